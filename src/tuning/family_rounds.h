#pragma once

#include <cstdint>
#include <vector>

#include "tuning/candidates.h"
#include "tuning/search.h"

namespace place_recognition {

/// How the images of the recordings are thinned out in each round.
struct Thinning {
  std::size_t first;  ///< in the first round, one of this many images of a place is used
  std::size_t last;   ///< likewise in the last round
};

/// For a search on `images` labelled images.
Thinning planThinning(std::uint64_t images, const SearchSpace& space);

/// Finds the best cue of each family by successive halving. The first round keeps a quarter of each
/// family, the second, with twice as many images, a single cue. For few images there is only one
/// round. The result of a family does not depend on the other families.
std::vector<CueOptions> bestOfEach(std::vector<Family> families, const Thinning& thinning,
                                   Search& search);

}  // namespace place_recognition
