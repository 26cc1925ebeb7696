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

#include "base/standing_stamp.h"
#include "labels/room_polygons.h"
#include "ros/labelers/labelled_recording.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Labels each image with the robot's room, from its pose on a map of rooms. The label is empty if
/// the room is not certain: the pose at that time is missing or uncertain, or the robot is near the
/// border of its room. Every image is recorded at once; its label, with the same time, follows as
/// soon as its pose arrives or is overdue. Callbacks come from one thread.
class AutoLabeler {
 public:
  /// Throws Error if the file of rooms, another parameter or the bag is unusable.
  AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// Labels the waiting images and ends the recording. Throws Error if there is no recording to
  /// keep.
  void finish();

 private:
  AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
              Parameters parameters);
  void onImage(const ImageMessage& image);
  void onPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose);

  /// An image that is recorded but not labelled yet.
  struct Waiting {
    ros::Time stamp;
    ros::Time arrival;
    ros::Time time;  // of the image and its label in the bag
  };

  /// Labels the waiting images, in order, up to the first whose pose may still arrive.
  void labelWaiting();
  bool mayStillCome(const Waiting& image) const;
  void label(const Waiting& image, const std::optional<Eigen::Vector2d>& position);
  /// Position of the robot at `stamp`, m; nothing if it is not known, for the reason in `problem_`.
  std::optional<Eigen::Vector2d> positionAt(const ros::Time& stamp);
  /// Names the frames that tf lacks, with those that it has; empty if it has both.
  std::string missingFrame() const;

  const RoomPolygons rooms_;
  const std::string map_frame_;
  const std::string robot_frame_;
  const double margin_;           // m
  const double max_deviation_;    // m
  const ros::Duration patience_;  // maximum delay of a pose
  double deviation_ = 0;          // m, of the pose; 0 until it is known
  StandingStamp standing_stamp_;
  std::deque<Waiting> waiting_;
  std::string problem_;  // why the last pose looked up is not known
  std::uint64_t labelled_ = 0;
  std::uint64_t unlabelled_ = 0;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_, false};  // in the threads of the node
  LabelledRecording recording_;
  ImageInput input_;
  ros::Subscriber pose_subscriber_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
