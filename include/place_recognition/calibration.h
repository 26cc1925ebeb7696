#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace place_recognition {

/// The probability, 0..1, that log odds stand for.
inline double logistic(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

/// What speaks for a frame showing any of the trained places at all, see Calibration::evidence().
struct EvidenceWeights {
  double decision_values = 1;  ///< of log sum_k exp(slope f_k), a smooth largest decision value
  double familiarity = 0;      ///< of the largest kernel value against a support vector
  double offset = 0;
};

/// Decision values to probabilities: p_k = exp(slope f_k) / sum_j exp(slope f_j). One slope for all
/// places, so that the most probable place is always the one of the largest decision value
/// (eq. 5.41).
///
/// A sigmoid for each place (Platt 1999) knows more numbers than a few hundred frames can tell: on
/// real rooms it was worse held out, by mean rate, by likelihood and by calibration error.
struct Calibration {
  double slope = 1;  ///< > 0
  EvidenceWeights weights = {};

  /// One per place; they sum to 1 and are finite for every finite input.
  Eigen::RowVectorXd probabilities(const Eigen::RowVectorXd& decision_values) const;

  /// How much speaks for any of the places at all, as log odds: the weighted sum of decision values
  /// and familiarity. Probabilities cannot tell: they sum to one also where every machine says no.
  /// Decision values alone cannot either: far from all support vectors they are just the biases.
  double logOdds(const Eigen::RowVectorXd& decision_values, double familiarity = 0) const;

  /// The same, 0..1: logistic(logOdds()).
  double evidence(const Eigen::RowVectorXd& decision_values, double familiarity = 0) const;

  /// log sum_k exp(slope f_k).
  double logSum(const Eigen::RowVectorXd& decision_values) const;
};

/// The slope of greatest likelihood on decision values (frames x places) of frames held out from
/// training, and their places. As in Platt's method the wanted probabilities are a little less than
/// certain, as if one frame in n + 1 told nothing, which keeps the slope finite. Without frames:
/// slope 1.
Calibration fitCalibration(const Eigen::MatrixXd& decision_values, const std::vector<int>& labels);

/// Weights such that decision values and familiarity count alike, each in units of its own spread
/// over frames of known places held out from training, and that evidence is 1/2 where all but a
/// `fraction` of these frames lie above, 0.95 at their median. No frames of unknown places are
/// needed.
EvidenceWeights fitEvidence(const Eigen::VectorXd& log_sums, const Eigen::VectorXd& familiarity,
                            double fraction);

}  // namespace place_recognition
