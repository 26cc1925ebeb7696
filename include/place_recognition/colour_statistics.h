#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// The colours of the images that a model was trained on, as the logarithms of the mean levels of
/// blue, green and red: what the light of a recording is held against.
struct ColourStatistics {
  Eigen::Matrix<double, Eigen::Dynamic, 3> means;  ///< one row per place
  Eigen::Matrix3d covariance;                      ///< of the images of a place, about its mean

  /// False for models no cue of which follows the light of a recording.
  bool known() const { return means.rows() > 0; }
};

}  // namespace place_recognition
