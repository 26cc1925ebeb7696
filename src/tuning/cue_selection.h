#pragma once

#include <vector>

#include "tuning/cue_comparison.h"
#include "tuning/search.h"

namespace place_recognition {

/// The cues that are combined: indices, ascending.
using Combination = std::vector<std::size_t>;

/// A greedy search that starts with the first `prior` cues and the weights of their options. Each
/// step replaces, adds or removes one cue, whichever lowers the log loss most. The search ends when
/// no step lowers it by more than four standard errors.
Combination chooseCues(const std::vector<CueComparison>& comparisons, std::size_t prior,
                       const TuningSamples& samples, Search& search);

/// Chooses C for the chosen cues: of those within one standard error of the best, the one closest
/// to the base's. Sets `search.best` to its trial.
void chooseC(const std::vector<CueComparison>& comparisons, const Combination& chosen,
             const TuningSamples& samples, Search& search);

}  // namespace place_recognition
