#include "recognition/training/sampling.h"

#include <algorithm>
#include <numeric>

namespace place_recognition {
std::vector<std::size_t> equalShares(const std::vector<std::size_t>& sizes, std::size_t most) {
  const std::size_t all = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  if (all <= most) return sizes;
  std::vector<std::size_t> fractions;
  for (const std::size_t size : sizes) fractions.push_back((size * most + all - 1) / all);
  return fractions;
}

std::vector<bool> stratifiedSample(const std::vector<int>& groups,
                                   const std::vector<std::size_t>& counts, std::uint64_t seed) {
  std::vector<std::vector<std::size_t>> members(counts.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    members[static_cast<std::size_t>(groups[i])].push_back(i);
  }
  std::mt19937_64 random(seed);
  std::vector<bool> kept(groups.size());
  for (std::size_t k = 0; k < members.size(); ++k) {
    const std::vector<std::size_t>& group = members[k];
    const std::size_t stretches = std::min(counts[k], group.size());
    for (std::size_t s = 0; s < stretches; ++s) {
      const std::size_t begin = s * group.size() / stretches;
      const std::size_t end = (s + 1) * group.size() / stretches;
      kept[group[begin + random() % (end - begin)]] = true;
    }
  }
  return kept;
}

std::vector<bool> stratifiedSample(const std::vector<int>& groups, std::size_t most,
                                   std::uint64_t seed) {
  std::vector<std::size_t> sizes;
  for (const int group : groups) {
    sizes.resize(std::max(sizes.size(), static_cast<std::size_t>(group) + 1));
    ++sizes[static_cast<std::size_t>(group)];
  }
  return stratifiedSample(groups, equalShares(sizes, most), seed);
}

bool StratifiedStream::keepsNext() {
  const std::size_t position = seen_++ % step_;
  if (position == 0) drawn_ = seen_ == 1 ? 0 : random_() % step_;
  return position == drawn_;
}

}  // namespace place_recognition
