#include "ros/messages/pose_conversions.h"

#include <cmath>

namespace place_recognition {
namespace {

/// Index of an element in the covariance of x, y, z and the rotations about them.
constexpr std::size_t at(std::size_t row, std::size_t column) { return 6 * row + column; }
constexpr std::size_t kYaw = 5;

}  // namespace

Eigen::Vector2d positionOf(const geometry_msgs::PoseWithCovariance& pose) {
  return {pose.pose.position.x, pose.pose.position.y};
}

Eigen::Matrix2d positionCovariance(const geometry_msgs::PoseWithCovariance& pose) {
  Eigen::Matrix2d covariance;
  covariance << pose.covariance[at(0, 0)], pose.covariance[at(0, 1)],  //
      pose.covariance[at(1, 0)], pose.covariance[at(1, 1)];
  return covariance;
}

OdometryPose toOdometryPose(const nav_msgs::Odometry& odometry) {
  const geometry_msgs::Point& position = odometry.pose.pose.position;
  const geometry_msgs::Quaternion& q = odometry.pose.pose.orientation;
  const double yaw = std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
  return {odometry.header.stamp.toSec(), position.x, position.y, yaw};
}

double largestDeviation(const Eigen::Matrix2d& covariance) {
  const double xx = covariance(0, 0);
  const double yy = covariance(1, 1);
  return std::sqrt((xx + yy) / 2 + std::hypot((xx - yy) / 2, covariance(0, 1)));
}

geometry_msgs::PoseWithCovariance toPose(const UniformDistribution& area) {
  geometry_msgs::PoseWithCovariance pose;
  pose.pose.position.x = area.mean.x();
  pose.pose.position.y = area.mean.y();
  pose.pose.orientation.w = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      pose.covariance[at(i, j)] =
          area.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  pose.covariance[at(kYaw, kYaw)] = std::pow(2 * M_PI, 2) / 12;
  return pose;
}

}  // namespace place_recognition
