#pragma once

#include <geometry_msgs/PoseWithCovariance.h>

#include <Eigen/Core>

#include "labels/polygon.h"

namespace place_recognition {

/// On the plane of the map, m; of the 6 x 6 covariance the elements 0, 1, 6 and 7.
Eigen::Vector2d positionOf(const geometry_msgs::PoseWithCovariance& pose);
Eigen::Matrix2d positionCovariance(const geometry_msgs::PoseWithCovariance& pose);

/// The standard deviation in the worst direction, the root of the larger eigenvalue of a
/// covariance.
double largestDeviation(const Eigen::Matrix2d& covariance);

/// The pose of a robot that is anywhere in `area`, m, and looks in any direction: its heading has
/// the variance of a uniform distribution over the circle, (2 pi)^2 / 12.
geometry_msgs::PoseWithCovariance toPose(const UniformDistribution& area);

}  // namespace place_recognition
