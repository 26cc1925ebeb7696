#pragma once

#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

// Several cues are combined by the weighted mean of their decision values over the cues that an
// image has (discriminative accumulation). Dividing by the weights that are present keeps the
// result in the units that it is calibrated in.

/// Held-out decision values of the cues, and their familiarity, combined; valid where any cue of
/// positive weight is.
HeldOutValues combine(const std::vector<HeldOutValues>& cues, const std::vector<double>& weights);

/// The weights that the options ask for, with the sum 1.
std::vector<double> priorWeights(const std::vector<CueOptions>& cues);

/// The weights for the mean rate of the rooms on held-out samples, with the sum 1: the mean of all
/// settings, multiples of `prior` in steps of a tenth (coarser for many cues), that are within two
/// standard errors of the best, because a few hundred frames cannot tell these apart. A cue whose
/// part of the mean is less than a fifth of an even one counts for nothing.
std::vector<double> chooseCueWeights(const std::vector<HeldOutValues>& cues,
                                     const std::vector<double>& prior,
                                     const std::vector<SampleOrigin>& samples, std::size_t places);

}  // namespace place_recognition
