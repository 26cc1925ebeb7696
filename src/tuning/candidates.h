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

/// A family for each set of descriptors in `space` that fits in, and one for each cue of `base`.
/// Each cue has a name of its own, made of what it is. Throws Error if there is nothing to try.
std::vector<Family> candidateFamilies(const TrainingOptions& base, const SearchSpace& space);

}  // namespace place_recognition
