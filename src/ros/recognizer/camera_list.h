#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "ros/nodes/parameters.h"

namespace place_recognition {

/// A camera of the robot, as the parameters say it.
struct CameraName {
  std::string name;   ///< for messages and topics below the node; empty: the only one
  std::string topic;  ///< of its images, without what the transport appends
  std::string model;  ///< of its own; empty: the one of all
};

/// The cameras of `~cameras`, each a topic or, without a slash, a name before /image_raw, with the
/// models of `~models`; if it is not set, one on `image`. Throws Error if a name is no topic,
/// stands there twice, or has no model though others do.
std::vector<CameraName> readCameras(Parameters& parameters);

/// How alike the cameras err as `~camera_correlation` gives it, one number for all pairs or one for
/// each (first and second, first and third, ...): cameras x cameras. Empty: not given. Throws Error
/// for any other number of numbers.
Eigen::MatrixXd readCameraCorrelation(Parameters& parameters, std::size_t cameras);

}  // namespace place_recognition
