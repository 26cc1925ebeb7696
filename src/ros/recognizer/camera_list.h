#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "ros/nodes/parameters.h"

namespace place_recognition {

/// A camera of the robot, as configured by the parameters.
struct CameraName {
  std::string name;   ///< for messages and topics below the node; empty: the only camera
  std::string topic;  ///< of its images, without the suffix of the transport
  std::string model;  ///< its own model; empty: the common one
};

/// Reads the cameras from `~cameras`, each a topic or, without a slash, a name before /image_raw,
/// with the models in `~models`. If it is not set, there is one camera on `image`. Throws Error if
/// a name is not a topic, occurs twice, or has no model although others do.
std::vector<CameraName> readCameras(Parameters& parameters);

/// Throws Error if two cameras have the same topic. `topics`: of each camera, after remapping.
void requireDifferentTopics(const std::vector<CameraName>& cameras,
                            const std::vector<std::string>& topics);

/// Reads the correlation of the cameras' errors from `~camera_correlation`, one number for all
/// pairs or one per pair (first and second, first and third, ...): cameras x cameras. Empty if it
/// is not set. Throws Error for any other count of numbers.
Eigen::MatrixXd readCameraCorrelation(Parameters& parameters, std::size_t cameras);

}  // namespace place_recognition
