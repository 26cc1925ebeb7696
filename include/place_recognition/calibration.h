#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace place_recognition {

/// Converts log odds to a probability, 0..1.
inline double logistic(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

/// Weights of what indicates that a frame shows any of the trained places; see
/// Calibration::evidence().
struct EvidenceWeights {
  double decision_values = 1;  ///< of log sum_k exp(slope f_k), a smooth largest decision value
  double familiarity = 0;      ///< of the largest kernel value against a support vector
  double offset = 0;
};

/// Converts decision values to probabilities: p_k = exp(slope f_k) / sum_j exp(slope f_j). All
/// places share one slope, so the most probable place is always the one with the largest decision
/// value (eq. 5.41).
///
/// A sigmoid per place (Platt 1999) has more parameters than a few hundred frames can determine: on
/// held-out frames of real rooms it was worse in mean rate, likelihood and calibration error.
struct Calibration {
  double slope = 1;  ///< > 0
  EvidenceWeights weights = {};

  /// One probability per place; they sum to 1 and are finite for every finite input.
  Eigen::RowVectorXd probabilities(const Eigen::RowVectorXd& decision_values) const;

  /// Log odds that the frame shows any of the places: the weighted sum of decision values (without
  /// Model::decision_limit) and familiarity. Probabilities cannot express this: they sum to one
  /// even if every machine rejects the frame. Neither can decision values alone: far from all
  /// support vectors they are just the biases.
  double logOdds(const Eigen::RowVectorXd& decision_values, double familiarity = 0) const;

  /// The same as a probability, 0..1: logistic(logOdds()).
  double evidence(const Eigen::RowVectorXd& decision_values, double familiarity = 0) const;

  /// log sum_k exp(slope f_k).
  double logSum(const Eigen::RowVectorXd& decision_values) const;
};

/// Finds the slope of maximum likelihood for decision values (frames x places) of frames held out
/// from training, and their places. As in Platt's method the target probabilities are slightly less
/// than certain, as if one frame in n + 1 carried no information; this keeps the slope finite.
/// Returns slope 1 if there are no frames.
Calibration fitCalibration(const Eigen::MatrixXd& decision_values, const std::vector<int>& labels);

/// Finds weights that give decision values and familiarity equal influence, each in units of its
/// own spread over frames of known places held out from training. Evidence is 1/2 at the value that
/// all but a `fraction` (below 1/2) of these frames exceed, and 0.95 at their median. No frames of
/// unknown places are needed.
EvidenceWeights fitEvidence(const Eigen::VectorXd& log_sums, const Eigen::VectorXd& familiarity,
                            double fraction);

}  // namespace place_recognition
