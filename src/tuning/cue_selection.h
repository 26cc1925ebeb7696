#pragma once

#include <vector>

#include "tuning/cue_comparison.h"
#include "tuning/search.h"

namespace place_recognition {

/// Which of the cues are combined: indices, ascending.
using Combination = std::vector<std::size_t>;

/// Starts with the first `prior` cues, combined with the weights of their options, and each time
/// takes the step that lowers the log loss most, as long as it does so by more than four standard
/// errors: another cue in place of one, one more, or one less.
Combination chooseCues(const std::vector<CueComparison>& comparisons, std::size_t prior,
                       const TuningSamples& samples, Search& search);

/// The C of the chosen cues: the one closest to that of the base within one standard error of the
/// best.
double chooseC(const std::vector<CueComparison>& comparisons, const Combination& chosen,
               const TuningSamples& samples, Search& search);

}  // namespace place_recognition
