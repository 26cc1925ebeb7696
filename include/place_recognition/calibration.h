#pragma once

#include <Eigen/Core>
#include <vector>

namespace place_recognition {

/// Margins to probabilities: p_k = exp(slope f_k) / sum_j exp(slope f_j). One slope for all places,
/// so that the most probable place is always the one of the largest margin (eq. 5.41).
///
/// A sigmoid for each place (Platt 1999) knows more numbers than a few hundred frames can tell: on
/// real rooms it was worse held out, by mean rate, by likelihood and by calibration error.
struct Calibration {
  double slope = 1;  ///< > 0

  /// Of each place; sum to 1. Finite for every finite input.
  Eigen::RowVectorXd probabilities(const Eigen::RowVectorXd& margins) const;

  /// How much speaks for any of the places at all, 0..1: the probability that they would share if
  /// 'none of them' were one more place, of margin 0, where each machine changes its answer.
  /// Probabilities cannot tell: they sum to one also where every machine says no.
  double evidence(const Eigen::RowVectorXd& margins) const;
};

/// The slope of greatest likelihood on margins (frames x places) of frames held out from training,
/// and their places. As in Platt's method the wanted probabilities are a little less than certain,
/// (n + 1) / (n + places) for n frames, which keeps the slope finite. Without frames: slope 1.
Calibration fitCalibration(const Eigen::MatrixXd& margins, const std::vector<int>& labels);

}  // namespace place_recognition
