#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/folds.h"
#include "recognition/model/scores.h"

namespace place_recognition {

/// Decision values of samples by machines that were trained without these samples and their
/// neighbours in time.
struct HeldOutValues {
  Eigen::MatrixXd decision_values;   ///< samples x places; zero if not valid
  std::vector<bool> valid;           ///< by sample: whether it has decision values
  Eigen::VectorXd familiarity = {};  ///< by sample: the largest kernel value; zero if not valid

  /// Those of `samples` samples, none of which is valid.
  static HeldOutValues none(std::size_t samples, std::size_t places);

  /// Sets the decision values and the largest kernel value of a sample, which becomes valid.
  void set(int sample, const Eigen::RowVectorXd& values, double largest_kernel_value);
};

/// Mean of the rooms' rates over the valid samples, by the largest decision value.
RoomMean roomRates(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places);

/// The mean of roomRates().
double averageRate(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places);

/// The pairs of places that the largest decision value confuses, over the valid samples.
std::vector<ConfusedPair> confusedPairs(const HeldOutValues& held_out,
                                        const std::vector<SampleOrigin>& samples,
                                        std::size_t places);

/// The loss -log(probability of the true place), in nats, of each of the `chosen` samples, after
/// calibration on the decision values of these same samples (one number, which a few hundred frames
/// determine well). It takes the certainty of the answers into account; the rate of a few hundred
/// frames only distinguishes right from wrong. A sample without decision values counts as uniform
/// probabilities. Probabilities count as at least a thousandth, so that no single frame decides.
std::vector<double> logLosses(const HeldOutValues& held_out,
                              const std::vector<SampleOrigin>& samples,
                              const std::vector<int>& chosen);

}  // namespace place_recognition
