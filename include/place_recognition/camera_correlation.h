#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace place_recognition {

/// A robot has this many cameras at most.
constexpr std::size_t kMaxCameras = 8;

/// The coefficient of two cameras of which nothing is known.
constexpr double kUnknownCorrelation = 0.5;

/// How alike the cameras of a robot err. What a second camera says of a moment is news only as far
/// as its errors are its own: in a dim corner, or behind a person, all of them may fail together.
struct CameraCorrelation {
  std::vector<std::string> cameras;  ///< topics of their images, without /compressed, ascending
  /// cameras x cameras, symmetric, 0..1, the diagonal 1: correlation of the log odds that two of
  /// them give the true place at the same moment.
  Eigen::MatrixXd coefficients;

  bool known() const { return !cameras.empty(); }
};

/// The coefficients for `cameras`. A pair that `learned` does not know has the mean of those that
/// it knows, and kUnknownCorrelation if it knows none.
Eigen::MatrixXd coefficientsFor(const std::vector<std::string>& cameras,
                                const CameraCorrelation& learned);

}  // namespace place_recognition
