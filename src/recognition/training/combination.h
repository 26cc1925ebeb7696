#pragma once

#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

// Cues are combined by the weighted mean of their decision values over the cues that an image has
// (discriminative accumulation). It is divided by the weights of the cues present, which keeps the
// result in the units of its calibration.

/// Combines the held-out decision values and familiarity of the cues; valid if any cue with
/// positive weight is.
HeldOutValues combine(const std::vector<HeldOutValues>& cues, const std::vector<double>& weights);

/// The weights in the options, scaled to sum 1.
std::vector<double> priorWeights(const std::vector<CueOptions>& cues);

/// Chooses weights, with sum 1, by the rooms' mean rate on held-out samples. The result is the mean
/// of all settings within two standard errors of the best, because a few hundred frames cannot
/// distinguish them. The settings are multiples of `prior` in steps of a tenth (coarser for many
/// cues). A cue whose weight in this mean is less than a fifth of an equal share gets weight 0.
std::vector<double> chooseCueWeights(const std::vector<HeldOutValues>& cues,
                                     const std::vector<double>& prior,
                                     const std::vector<SampleOrigin>& samples, std::size_t places);

}  // namespace place_recognition
