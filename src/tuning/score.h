#pragma once

#include <vector>

#include "recognition/training/cross_validation.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// How held-out answers fared.
struct Score {
  double log_loss = 0;         ///< mean of the rooms' means of `losses`, nats
  double standard_error = 0;   ///< of log_loss, as if images were independent
  double rate = 0;             ///< mean of the rooms' rates on images as recorded
  double changed_rate = 0;     ///< the same on changed ones; 0 if there are none
  std::vector<double> losses;  ///< of each recorded sample, mean over its images; 0: never tested
};

/// Scores decision values by -log of the probability that they give to the true room, after
/// calibration on these very decision values (one number, which a few hundred images determine
/// well). A sample whose decision values are missing counts as an answer that knows nothing.
Score score(const HeldOutValues& held_out, const TuningSamples& samples);

/// Standard error of the difference of two scores' log losses: images that are hard for both
/// cancel out. As if images were independent.
double differenceError(const Score& a, const Score& b, const TuningSamples& samples);

}  // namespace place_recognition
