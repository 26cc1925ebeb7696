#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>

#include <optional>
#include <string>

#include "labels/polygon.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Restarts amcl, or another node with its topics, in the robot's room when it is lost: when the
/// deviation of its position exceeds `~lost_deviation`, when its pose is not finite, or when it has
/// not published one.
/// Does nothing unless `~publish` is set. Not thread-safe.
class Relocalizer {
 public:
  /// Rooms are on the map in the tf frame `map_frame`. Throws Error if a parameter is invalid.
  Relocalizer(const ros::NodeHandle& node, Parameters& parameters, const std::string& map_frame);

  /// Reports that the robot is certainly in `room`, anywhere in `area`. Publishes `initialpose` if
  /// amcl is lost, if amcl does not know the room yet, and if the last time is at least `~interval`
  /// ago. Warns once about what prevents publishing.
  void robotIsIn(const std::string& room, const UniformDistribution& area, const ros::Time& now);

  /// Call it regularly: warns if amcl does not answer.
  void watch(const ros::Time& now);

  /// Call it when time was set back: what was published counts as never published.
  void forget();

 private:
  void onAmclPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose);
  bool isLost(const ros::Time& now) const;
  /// Whether amcl already locates itself in `area`, with at least the certainty that the room
  /// provides.
  bool knows(const UniformDistribution& area) const;
  bool isHeard();
  std::string stateText() const;

  const std::string map_frame_;
  const bool publish_;
  const double lost_deviation_;                                 // m
  const double interval_;                                       // s
  geometry_msgs::PoseWithCovarianceStampedConstPtr amcl_pose_;  // null: none has arrived
  std::optional<ros::Time> first_time_;                         // at which a room was first certain
  std::optional<ros::Time> told_;                               // when amcl was last told
  bool answered_ = true;  // whether amcl has answered since then
  bool warned_of_frame_ = false;
  bool warned_of_silence_ = false;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace place_recognition
