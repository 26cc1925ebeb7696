#include "experiments/training_subsets.h"

#include <algorithm>

namespace place_recognition {
namespace {

/// The samples of `train` by place, each list in the original order.
std::vector<std::vector<int>> byPlace(const std::vector<int>& train, const SetSamples& samples) {
  std::vector<std::vector<int>> places(static_cast<std::size_t>(samples.place_count));
  for (const int i : train) {
    const int place = samples.places[static_cast<std::size_t>(i)];
    places[static_cast<std::size_t>(place)].push_back(i);
  }
  return places;
}

}  // namespace

std::vector<int> subsetOf(const std::vector<int>& train, const SetSamples& samples, int count,
                          SubsetKind kind) {
  std::vector<int> subset;
  for (const std::vector<int>& all : byPlace(train, samples)) {
    const std::size_t n = all.size();
    const std::size_t wanted = std::min(n, static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < wanted; ++k) {
      const std::size_t index =
          kind == SubsetKind::kSpread ? (2 * k + 1) * n / (2 * wanted) : (n - wanted) / 2 + k;
      subset.push_back(all[index]);
    }
  }
  std::sort(subset.begin(), subset.end());
  return subset;
}

std::vector<Viewpoint> viewpointsOf(const std::vector<int>& train, const SetSamples& samples) {
  std::vector<Viewpoint> viewpoints;
  int place = 0;
  for (const std::vector<int>& all : byPlace(train, samples)) {
    for (std::size_t begin = 0; begin < all.size(); begin += kViewpointSamples) {
      const std::size_t end = std::min(all.size(), begin + kViewpointSamples);
      viewpoints.push_back({place,
                            static_cast<int>(begin / kViewpointSamples) + 1,
                            {all.begin() + static_cast<std::ptrdiff_t>(begin),
                             all.begin() + static_cast<std::ptrdiff_t>(end)}});
    }
    ++place;
  }
  return viewpoints;
}

}  // namespace place_recognition
