#pragma once

#include <Eigen/Core>
#include <vector>

namespace place_recognition {

/// Margins to probabilities: for each place k a sigmoid s_k(f) = 1 / (1 + exp(slope_k f +
/// offset_k)) (Platt 1999, fitted as Lin, Lin and Weng 2007), normalised over the places.
struct Calibration {
  Eigen::RowVectorXd slopes;   ///< one a place, negative
  Eigen::RowVectorXd offsets;  ///< one a place

  /// s_k of each place, 0..1, not normalised.
  Eigen::RowVectorXd sigmoids(const Eigen::RowVectorXd& margins) const;
  /// Normalised: sums to 1. Finite for every finite input.
  Eigen::RowVectorXd probabilities(const Eigen::RowVectorXd& margins) const;
};

/// Fits on margins (frames x places) of frames held out from training, and their places.
Calibration fitCalibration(const Eigen::MatrixXd& margins, const std::vector<int>& labels);

}  // namespace place_recognition
