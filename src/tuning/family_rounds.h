#pragma once

#include <cstdint>
#include <vector>

#include "tuning/candidates.h"
#include "tuning/search.h"

namespace place_recognition {

/// How the images of the recordings are thinned out from round to round.
struct Thinning {
  std::size_t first;  ///< one of so many images of a place in the first round
  std::size_t last;   ///< and in the last
};

/// For a search on `images` labelled images.
Thinning planThinning(std::uint64_t images, const SearchSpace& space);

/// The best cue of each family by successive halving: the first round keeps a quarter of each
/// family, the second, on twice as many images, one cue. A single round is enough if there are few
/// images. No family's result depends on the other families.
std::vector<CueOptions> bestOfEach(std::vector<Family> families, const Thinning& thinning,
                                   Search& search);

}  // namespace place_recognition
