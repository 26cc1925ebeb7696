#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// Colours of the images that a model was trained on, as logarithms of the mean levels of blue,
/// green and red: the reference for the light of a recording.
struct ColourStatistics {
  Eigen::Matrix<double, Eigen::Dynamic, 3> means;  ///< one row per place
  Eigen::Matrix3d covariance;                      ///< of the images of a place about their mean

  /// False if no cue of the model follows the light of a recording.
  bool known() const { return means.rows() > 0; }
};

}  // namespace place_recognition
