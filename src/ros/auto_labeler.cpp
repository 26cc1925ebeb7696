#include "ros/auto_labeler.h"

#include <cmath>

#include "place_recognition/error.h"
#include "ros/node_names.h"

namespace place_recognition {
namespace {

RoomPolygons roomsOf(const ros::NodeHandle& private_node) {
  const auto path = private_node.param<std::string>("rooms", "");
  if (path.empty()) throw Error("The parameter ~rooms is not set; name a file of room polygons.");
  return readRoomPolygons(path);
}

/// Standard deviation of the position in its worst direction: of the covariance of x and y
/// (elements 0, 1 and 7 of the 6 x 6), the root of the larger eigenvalue, m.
double deviation(const geometry_msgs::PoseWithCovariance& pose) {
  const double xx = pose.covariance[0];
  const double xy = pose.covariance[1];
  const double yy = pose.covariance[7];
  return std::sqrt((xx + yy) / 2 + std::hypot((xx - yy) / 2, xy));
}

}  // namespace

AutoLabeler::AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : rooms_(roomsOf(private_node)),
      map_frame_(private_node.param<std::string>("map_frame", "map")),
      robot_frame_(private_node.param<std::string>("robot_frame", "base_link")),
      margin_(private_node.param("margin", 0.3)),
      max_deviation_(private_node.param("max_deviation", 0.5)),
      patience_(private_node.param("pose_timeout", 0.2)),
      recording_(node, private_node),
      input_(
          node, private_node, [this](const ImageMessage& image) { onImage(image); },
          names::kRecordingQueue) {
  pose_subscriber_ = ros::NodeHandle(node).subscribe(names::kPose, 1, &AutoLabeler::onPose, this);
  input_.subscribe();
  ROS_INFO("%zu rooms; labelling by the pose of %s in %s.", rooms_.size(), robot_frame_.c_str(),
           map_frame_.c_str());
}

void AutoLabeler::onImage(const ImageMessage& image) {
  const ros::Time now = ros::Time::now();  // label and image have the same time in the bag
  const std::optional<Eigen::Vector2d> position = positionAt(image.header().stamp);
  const bool sure = position && deviation_ <= max_deviation_;  // false if it is NaN
  recording_.say(sure ? rooms_.at(*position, margin_) : "", now);
  recording_.add(image, now);
}

void AutoLabeler::onPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose) {
  deviation_ = deviation(pose->pose);
}

std::optional<Eigen::Vector2d> AutoLabeler::positionAt(const ros::Time& stamp) const {
  if (stamp.isZero()) {  // tf would take it for "the latest"
    ROS_WARN_THROTTLE(10, "The images have no stamp; they cannot be labelled by the pose.");
    return std::nullopt;
  }
  try {
    const geometry_msgs::Vector3 position =
        transforms_.lookupTransform(map_frame_, robot_frame_, stamp, patience_)
            .transform.translation;
    return Eigen::Vector2d(position.x, position.y);
  } catch (const tf2::TransformException& e) {
    ROS_WARN_THROTTLE(10, "No label for want of a pose: %s", e.what());
    return std::nullopt;
  }
}

}  // namespace place_recognition
