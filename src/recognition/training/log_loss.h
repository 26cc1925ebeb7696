#pragma once

#include <vector>

#include "recognition/training/held_out.h"

namespace place_recognition {

/// -log of the probability given to the true place, in nats, for each of `chosen` samples, after
/// calibration on the margins of these very samples (one number, which a few hundred frames
/// determine well). Uses how sure the answers are, where a rate of a few hundred frames only knows
/// right and wrong. A sample without margins counts as an answer that knows nothing; no probability
/// counts as less than a thousandth, so that no single frame decides.
std::vector<double> logLosses(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                              const std::vector<int>& chosen);

}  // namespace place_recognition
