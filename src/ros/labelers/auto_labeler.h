#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "labels/room_polygons.h"
#include "ros/labelers/labelled_recording.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Says where the robot was when each image was taken, by its pose on a map of rooms. Says nothing
/// (an empty label) where that is not sure: the pose of that time is missing, it is uncertain, or
/// the robot is near the border of its room. Every image is recorded at once; its label, which has
/// its time, follows as soon as its pose has come, or has not come in time. Callbacks come from one
/// thread.
class AutoLabeler {
 public:
  /// Throws Error if the file of rooms, another parameter or the bag cannot be used.
  AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// Labels what still waits and ends the recording. Throws Error if there is none to keep.
  void finish();

 private:
  AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
              Parameters parameters);
  void onImage(const ImageMessage& image);
  void onPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose);

  /// An image that is recorded, but not labelled yet.
  struct Waiting {
    ros::Time stamp;
    ros::Time arrival;
    ros::Time time;  // in the bag, which its label has too
  };

  /// Labels the images that wait, in order, up to the first whose pose may still come.
  void labelWaiting();
  bool mayStillCome(const Waiting& image) const;
  void label(const Waiting& image, const std::optional<Eigen::Vector2d>& position);
  /// Where the robot was at `stamp`, m; nothing, and `problem_` says why: that is not known.
  std::optional<Eigen::Vector2d> positionAt(const ros::Time& stamp);
  /// Which of the two frames tf does not have, with those that it has; empty: it has both.
  std::string missingFrame() const;

  const RoomPolygons rooms_;
  const std::string map_frame_;
  const std::string robot_frame_;
  const double margin_;           // m
  const double max_deviation_;    // m
  const ros::Duration patience_;  // how long a pose may take to come
  double deviation_ = 0;          // m, of the pose; 0 as long as nobody tells it
  std::deque<Waiting> waiting_;
  std::string problem_;  // why the pose that was looked up last is not known
  std::uint64_t labelled_ = 0;
  std::uint64_t unlabelled_ = 0;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
  LabelledRecording recording_;
  ImageInput input_;
  ros::Subscriber pose_subscriber_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
