#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>

#include <optional>
#include <string>

#include "labels/polygon.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Has amcl, or what speaks its topics, start anew in the robot's room when it is lost: when its
/// position deviates by more than `~lost_deviation`, or when it has not said any. Does nothing
/// unless `~publish`. Not thread-safe.
class Relocalizer {
 public:
  /// Rooms are on the map of the tf frame `map_frame`. Throws Error if a parameter is wrong.
  Relocalizer(const ros::NodeHandle& node, Parameters& parameters, const std::string& map_frame);

  /// The robot surely is in `room`, anywhere in `area`. Publishes `initialpose` if amcl is lost, if
  /// the room is news to it, and if the last time is `~interval` ago. Warns, once, of what prevents
  /// that.
  void robotIsIn(const std::string& room, const UniformDistribution& area, const ros::Time& now);

  /// To be called now and then: warns if amcl does not answer.
  void watch(const ros::Time& now);

  /// Time was set back: what was published counts as never published.
  void forget();

 private:
  void onAmclPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose);
  bool isLost(const ros::Time& now) const;
  /// Whether amcl takes itself to be in `area` already, as surely as a room tells it.
  bool knows(const UniformDistribution& area) const;
  bool isHeard();
  std::string stateText() const;

  const std::string map_frame_;
  const bool publish_;
  const double lost_deviation_;                                 // m
  const double interval_;                                       // s
  geometry_msgs::PoseWithCovarianceStampedConstPtr amcl_pose_;  // null: none has come
  std::optional<ros::Time> first_time_;                         // that a room was sure
  std::optional<ros::Time> told_;                               // when amcl was told last
  bool answered_ = true;                                        // by amcl, since then
  bool warned_of_frame_ = false;
  bool warned_of_silence_ = false;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace place_recognition
