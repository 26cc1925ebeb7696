#include "recognition/training/sampling.h"

#include <algorithm>

namespace place_recognition {

std::vector<bool> stratifiedSample(const std::vector<int>& groups, std::size_t most,
                                   std::uint64_t seed) {
  const std::size_t count = groups.size();
  if (count <= most) return std::vector<bool>(count, true);
  std::vector<std::vector<std::size_t>> members(
      static_cast<std::size_t>(*std::max_element(groups.begin(), groups.end())) + 1);
  for (std::size_t i = 0; i < count; ++i) {
    members[static_cast<std::size_t>(groups[i])].push_back(i);
  }
  std::mt19937_64 random(seed);
  std::vector<bool> kept(count);
  for (const std::vector<std::size_t>& group : members) {
    const std::size_t stretches = (group.size() * most + count - 1) / count;
    for (std::size_t s = 0; s < stretches; ++s) {
      const std::size_t begin = s * group.size() / stretches;
      const std::size_t end = (s + 1) * group.size() / stretches;
      kept[group[begin + random() % (end - begin)]] = true;
    }
  }
  return kept;
}

bool StratifiedStream::keepsNext() {
  const std::size_t position = seen_++ % step_;
  if (position == 0) drawn_ = seen_ == 1 ? 0 : random_() % step_;
  return position == drawn_;
}

}  // namespace place_recognition
