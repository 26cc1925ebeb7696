#pragma once

#include <string>
#include <vector>

#include "place_recognition/tuning.h"

namespace place_recognition {

/// Cues of one set of descriptors in different scales and bins, of which the best is to be found;
/// the simplest first: few dimensions, then few bins.
struct Family {
  std::string name;  ///< the descriptors
  std::vector<CueOptions> cues;
};

/// A family for each set of descriptors in `space` that fits in: derivatives as ratios, colours
/// both in the light of the recording and grey-world (as the default cues have it,
/// doc/experiments.md). Each cue has a name of its own, made of what it is.
std::vector<Family> candidateFamilies(const SearchSpace& space);

}  // namespace place_recognition
