// Poses of messages against rotations composed by Eigen.

#include "ros/messages/pose_conversions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace place_recognition {
namespace {

nav_msgs::Odometry odometryAt(double x, double y, const Eigen::Quaterniond& rotation) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(12, 500000000);
  odometry.pose.pose.position.x = x;
  odometry.pose.pose.position.y = y;
  odometry.pose.pose.position.z = 7;
  odometry.pose.pose.orientation.w = rotation.w();
  odometry.pose.pose.orientation.x = rotation.x();
  odometry.pose.pose.orientation.y = rotation.y();
  odometry.pose.pose.orientation.z = rotation.z();
  return odometry;
}

TEST(OdometryPoses, HaveTheStampAndThePositionOfTheMessage) {
  const OdometryPose pose = toOdometryPose(odometryAt(3, -2, Eigen::Quaterniond::Identity()));
  EXPECT_EQ(pose.stamp, 12.5);
  EXPECT_EQ(pose.x, 3);
  EXPECT_EQ(pose.y, -2);
  EXPECT_EQ(pose.yaw, 0);
}

TEST(OdometryPoses, HaveTheYawOfTheRotationWhateverItsRollAndPitch) {
  for (const double yaw : {-3.1, -1.5, 0.0, 0.4, 2.0, 3.1}) {
    for (const double pitch : {-0.3, 0.0, 0.2}) {
      for (const double roll : {-0.4, 0.0, 0.1}) {
        const Eigen::Quaterniond rotation = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                            Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                            Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
        EXPECT_NEAR(toOdometryPose(odometryAt(0, 0, rotation)).yaw, yaw, 1e-12)
            << pitch << ' ' << roll;
      }
    }
  }
}

}  // namespace
}  // namespace place_recognition
