#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Core>
#include <optional>
#include <string>

#include "ros/image_input.h"
#include "ros/labelled_recording.h"
#include "ros/room_polygons.h"

namespace place_recognition {

/// Says where the robot was when each image was taken, by its pose on a map of rooms. Says nothing
/// (an empty label) where that is not sure: the pose of that time is missing, it is uncertain, or
/// the robot is near the border of its room. Callbacks come from one thread.
class AutoLabeler {
 public:
  /// Throws Error if the file of rooms, another parameter or the bag cannot be used.
  AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

 private:
  void onImage(const ImageMessage& image);
  void onPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose);

  /// Where the robot was at `stamp`, m; nothing: that is not known.
  std::optional<Eigen::Vector2d> positionAt(const ros::Time& stamp) const;

  const RoomPolygons rooms_;
  const std::string map_frame_;
  const std::string robot_frame_;
  const double margin_;           // m
  const double max_deviation_;    // m
  const ros::Duration patience_;  // how long a pose may take to come
  double deviation_ = 0;          // m, of the pose; 0 as long as nobody tells it
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
  LabelledRecording recording_;
  ImageInput input_;
  ros::Subscriber pose_subscriber_;
};

}  // namespace place_recognition
