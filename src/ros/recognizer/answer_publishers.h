#pragma once

#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>

#include <functional>
#include <string>

#include "base/place_name.h"
#include "ros/recognizer/place_tracker.h"

namespace place_recognition {

/// The topics of the answers: `~recognition` for each frame, and for the answers over time `~place`
/// (latched, when it changes), `~belief`, `~smoothed` and `~marker`. Not thread-safe, except for
/// isWanted().
class AnswerPublishers {
 public:
  /// `changed` is called, from any thread, when somebody starts or stops listening.
  void advertise(ros::NodeHandle private_node, const std::function<void()>& changed);

  /// Whether anybody listens.
  bool isWanted() const;

  void publishFrame(const PlaceRecognition& message) { recognition_.publish(message); }

  /// `message` answers the frame with which `tracker` was last updated; `place` is the current
  /// place.
  void publishOverTime(const std::string& place, const PlaceRecognition& message,
                       PlaceTracker& tracker);

  /// Publishes that the place is unknown, because everything seen is discarded.
  void forget(PlaceTracker& tracker);

  /// The place last published.
  const std::string& place() const { return last_place_; }

 private:
  void publishPlace(const std::string& place);
  void publishSmoothed(const PlaceRecognition& message, PlaceTracker& tracker);

  ros::Publisher recognition_, place_, belief_, smoothed_, marker_;
  std::string last_place_;
};

}  // namespace place_recognition
