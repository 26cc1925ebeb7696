#pragma once

#include <vector>

#include "tuning/cue_comparison.h"
#include "tuning/search.h"

namespace place_recognition {

/// A cue in question with its gamma, and how it fares alone.
struct CueChoice {
  const CueComparison* comparison;
  double gamma;
  HeldOut held_out;
  Score score;
};

/// The gamma of each cue: the one closest to neutral within one standard error of the best.
std::vector<CueChoice> chooseGammas(const std::vector<CueComparison>& comparisons,
                                    const TuningSamples& samples, Search& search);

/// Cues to be combined: the best one, and then each time the one that lowers the log loss of all
/// with equal weights most, as long as it does so by more than two standard errors.
std::vector<CueChoice> chooseCues(std::vector<CueChoice> choices, const TuningSamples& samples,
                                  Search& search);

/// The C of the chosen cues: the one closest to that of the base within one standard error of the
/// best.
double chooseC(const std::vector<CueChoice>& chosen, const TuningSamples& samples, Search& search);

}  // namespace place_recognition
