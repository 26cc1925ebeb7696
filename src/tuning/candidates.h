#pragma once

#include <string>
#include <vector>

#include "place_recognition/tuning.h"

namespace place_recognition {

/// Candidate cues with one set of descriptors and different scales and bins, the simplest first:
/// by dimensions, then by bins.
struct Family {
  std::string name;  ///< the descriptors
  std::vector<CueOptions> cues;
};

/// One family for each set of descriptors in `space`, without cues of too many dimensions. As in
/// the default cues (doc/choices.md), derivatives have logarithmic levels, and colours are
/// normalized both by the light of the recording and by grey-world. Each cue has a descriptive,
/// unique name.
std::vector<Family> candidateFamilies(const SearchSpace& space);

}  // namespace place_recognition
