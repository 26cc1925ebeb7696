#include "ros/localization/relocalizer.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "ros/messages/pose_conversions.h"
#include "ros/nodes/node_names.h"
#include "ros/nodes/seconds_between.h"

namespace place_recognition {
namespace {

/// Time for amcl's latched pose to arrive before amcl counts as having none, s.
constexpr double kFirstPosePatience = 1;
/// Time for amcl to answer a pose, s; it answers with the next scan.
constexpr double kAnswerPatience = 5;
/// amcl knows the room if the squared Mahalanobis distance of its mean is at most that of a
/// rectangle's corners from its centre, and its deviation is at most this many times the room's.
/// The deviation of particles drawn from a room varies a little around that of the room.
constexpr double kSameRoomDistance = 6;
constexpr double kSameRoomDeviation = 1.5;

/// The frame without the leading slash that tf1 allowed.
std::string plain(const std::string& frame) {
  return startsWith(frame, "/") ? frame.substr(1) : frame;
}

/// Standard deviation of the position in its worst direction, m; infinite if the pose is not
/// finite.
double deviationOf(const geometry_msgs::PoseWithCovarianceStamped& pose) {
  const double deviation = largestDeviation(positionCovariance(pose.pose));
  const bool finite = positionOf(pose.pose).allFinite() && std::isfinite(deviation);
  return finite ? deviation : std::numeric_limits<double>::infinity();
}

}  // namespace

Relocalizer::Relocalizer(const ros::NodeHandle& node, Parameters& parameters,
                         const std::string& map_frame)
    : map_frame_(plain(map_frame)),
      publish_(parameters.flag("publish", false)),
      lost_deviation_(parameters.real("lost_deviation", 1, 0)),
      interval_(parameters.real("interval", 60, 0)) {
  if (!publish_) return;
  ros::NodeHandle handle(node);
  publisher_ = handle.advertise<geometry_msgs::PoseWithCovarianceStamped>(names::kInitialPose, 1);
  subscriber_ = handle.subscribe(names::kAmclPose, 1, &Relocalizer::onAmclPose, this);
}

void Relocalizer::onAmclPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose) {
  amcl_pose_ = pose;
  answered_ = true;
  const std::string frame = plain(pose->header.frame_id);
  if (frame == map_frame_ || warned_of_frame_) return;
  warned_of_frame_ = true;
  ROS_WARN(
      "%s is in the frame '%s', but the rooms are in '%s'; no pose will be sent to amcl. Set "
      "~map_frame to '%s' if the rooms are on that map.",
      subscriber_.getTopic().c_str(), frame.c_str(), map_frame_.c_str(), frame.c_str());
}

bool Relocalizer::isLost(const ros::Time& now) const {
  if (!amcl_pose_) return secondsBetween(*first_time_, now) >= kFirstPosePatience;
  return deviationOf(*amcl_pose_) > lost_deviation_;
}

bool Relocalizer::knows(const UniformDistribution& area) const {
  if (!amcl_pose_) return false;
  const Eigen::Vector2d offset = positionOf(amcl_pose_->pose) - area.mean;
  return offset.dot(area.covariance.inverse() * offset) <= kSameRoomDistance &&
         deviationOf(*amcl_pose_) <= kSameRoomDeviation * largestDeviation(area.covariance);
}

bool Relocalizer::isHeard() {
  const bool heard = publisher_.getNumSubscribers() > 0;
  if (!heard && !warned_of_silence_) {
    ROS_WARN("%s, but nobody subscribes to %s; check that amcl is running and uses that topic.",
             stateText().c_str(), publisher_.getTopic().c_str());
  }
  warned_of_silence_ = !heard;
  return heard;
}

std::string Relocalizer::stateText() const {
  if (!amcl_pose_) return "No pose has arrived on " + subscriber_.getTopic();
  const double deviation = deviationOf(*amcl_pose_);
  if (!std::isfinite(deviation)) return "amcl is lost (its pose is not finite)";
  return "amcl is lost (its position deviates by " + fixed(deviation, 2) + " m)";
}

void Relocalizer::robotIsIn(const std::string& room, const UniformDistribution& area,
                            const ros::Time& now) {
  if (!publish_) return;
  if (!first_time_) first_time_ = now;
  const bool too_early = told_ && secondsBetween(*told_, now) < interval_;
  if (too_early || !isLost(now) || knows(area)) return;
  const bool same_map = !amcl_pose_ || plain(amcl_pose_->header.frame_id) == map_frame_;
  if (!same_map || !isHeard()) return;
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = map_frame_;
  message.header.stamp = now;
  message.pose = toPose(area);
  publisher_.publish(message);
  told_ = now;
  answered_ = false;
  ROS_INFO("%s; restarting it in '%s', around (%.2f, %.2f).", stateText().c_str(), room.c_str(),
           area.mean.x(), area.mean.y());
}

void Relocalizer::watch(const ros::Time& now) {
  if (answered_ || secondsBetween(*told_, now) < kAnswerPatience) return;
  answered_ = true;  // so that this is reported only once
  ROS_WARN(
      "No pose has arrived on %s for %.0f s after one was published on %s; check that amcl gets "
      "scans and that its map is in the frame '%s'.",
      subscriber_.getTopic().c_str(), kAnswerPatience, publisher_.getTopic().c_str(),
      map_frame_.c_str());
}

void Relocalizer::forget() {
  first_time_.reset();
  told_.reset();
  answered_ = true;
}

}  // namespace place_recognition
