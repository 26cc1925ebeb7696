#pragma once

#include <geometry_msgs/PoseWithCovariance.h>
#include <nav_msgs/Odometry.h>

#include <Eigen/Core>

#include "labels/polygon.h"
#include "recognition/over_time/odometry_accumulator.h"

namespace place_recognition {

/// In the plane of the map, m; elements 0, 1, 6 and 7 of the 6 x 6 covariance.
Eigen::Vector2d positionOf(const geometry_msgs::PoseWithCovariance& pose);
Eigen::Matrix2d positionCovariance(const geometry_msgs::PoseWithCovariance& pose);

/// The pose in the plane; roll and pitch, about the fixed axes x and y, are ignored.
OdometryPose toOdometryPose(const nav_msgs::Odometry& odometry);

/// The standard deviation in the worst direction: the square root of a covariance's larger
/// eigenvalue.
double largestDeviation(const Eigen::Matrix2d& covariance);

/// The pose of a robot that is anywhere in `area`, m, and faces in any direction: the variance of
/// its heading is that of a uniform distribution over the circle, (2 pi)^2 / 12.
geometry_msgs::PoseWithCovariance toPose(const UniformDistribution& area);

}  // namespace place_recognition
