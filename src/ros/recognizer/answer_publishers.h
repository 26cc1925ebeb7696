#pragma once

#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>

#include <functional>
#include <string>

#include "base/place_name.h"
#include "ros/recognizer/place_tracker.h"

namespace place_recognition {

/// The topics of the answers: `~recognition` of each frame, and what the frames amount to over
/// time:
/// `~place` (latched, when it changes), `~belief`, `~smoothed`, `~marker`. Not thread-safe but for
/// isWanted().
class AnswerPublishers {
 public:
  /// `changed` is called, from any thread, when somebody begins or ceases to listen.
  void advertise(ros::NodeHandle private_node, const std::function<void()>& changed);

  /// Whether anybody listens.
  bool isWanted() const;

  void publishFrame(const PlaceRecognition& message) { recognition_.publish(message); }

  /// `message` answers the frame that `tracker` was updated with last; the place is `place` now.
  void publishOverTime(const std::string& place, const PlaceRecognition& message,
                       PlaceTracker& tracker);

  /// What was seen is forgotten: the place is unknown.
  void forget(PlaceTracker& tracker);

  /// As published last.
  const std::string& place() const { return last_place_; }

 private:
  void publishPlace(const std::string& place);
  void publishSmoothed(const PlaceRecognition& message, PlaceTracker& tracker);

  ros::Publisher recognition_, place_, belief_, smoothed_, marker_;
  std::string last_place_;
};

}  // namespace place_recognition
