#pragma once

#include <vector>

#include "tuning/candidates.h"
#include "tuning/search.h"

namespace place_recognition {

/// How the images of the recordings are thinned out from round to round.
struct Thinning {
  std::size_t first;  ///< one of so many images of a place in the first round
  std::size_t last;   ///< and in the last
};

/// Counts the labelled images of the recordings and decides.
Thinning planThinning(const TuningRecordings& recordings, const SearchSpace& space,
                      const Progress& progress, std::uint64_t& images);

/// The best cue of each family by successive halving: the first round leaves
/// a quarter of each family, the second, on twice as many images, one. Where all images are
/// few, one round does.
std::vector<CueOptions> bestOfEach(std::vector<Family> families, const Thinning& thinning,
                                   Search& search);

}  // namespace place_recognition
