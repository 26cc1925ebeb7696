#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace place_recognition {

/// Maximum number of cameras of a robot.
constexpr std::size_t kMaxCameras = 8;

/// Coefficient of two cameras that were never seen together.
constexpr double kUnknownCorrelation = 0.5;

/// Correlation of the errors of a robot's cameras. A second camera adds information only as far as
/// its errors are independent: in a dim corner, or behind a person, all cameras may fail together.
struct CameraCorrelation {
  std::vector<std::string> cameras;  ///< topics of their images, without /compressed, ascending
  /// cameras x cameras, symmetric, 0..1, with ones on the diagonal: the correlation of the log odds
  /// that two cameras give the true place at the same moment.
  Eigen::MatrixXd coefficients;

  bool known() const { return !cameras.empty(); }
};

/// The coefficients for `cameras`. A pair missing in `learned` gets the mean of the pairs in it, or
/// kUnknownCorrelation if it has none.
Eigen::MatrixXd coefficientsFor(const std::vector<std::string>& cameras,
                                const CameraCorrelation& learned);

}  // namespace place_recognition
