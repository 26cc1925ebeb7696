#pragma once

#include <vector>

#include "recognition/training/held_out_values.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// The quality of held-out answers.
struct Score {
  double log_loss = 0;         ///< mean of the rooms' means of `losses`, nats
  double standard_error = 0;   ///< of log_loss, as if images were independent
  double rate = 0;             ///< mean of the rooms' rates for images as recorded
  double changed_rate = 0;     ///< the same for changed images; 0 if there are none
  std::vector<double> losses;  ///< per recorded sample, the mean over its images; 0: never tested
};

/// Scores decision values by -log of the probability of the true room, after calibration on these
/// same decision values (one number, which a few hundred images determine well). A sample without
/// decision values counts as uniform probabilities.
Score score(const HeldOutValues& held_out, const TuningSamples& samples);

/// Standard error of the difference of two log losses, as if images were independent. Images that
/// are hard for both cancel out.
double differenceError(const Score& a, const Score& b, const TuningSamples& samples);

}  // namespace place_recognition
