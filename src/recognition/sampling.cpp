#include "recognition/sampling.h"

#include <algorithm>

namespace place_recognition {

std::vector<bool> evenShare(const std::vector<int>& groups, std::size_t most) {
  const std::size_t count = groups.size();
  if (count <= most) return std::vector<bool>(count, true);
  const auto kept_of = [&](std::size_t members) { return (members * most + count - 1) / count; };
  std::vector<std::size_t> seen(
      static_cast<std::size_t>(*std::max_element(groups.begin(), groups.end())) + 1);
  std::vector<bool> kept(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t& members = seen[static_cast<std::size_t>(groups[i])];
    kept[i] = kept_of(members + 1) > kept_of(members);
    ++members;
  }
  return kept;
}

}  // namespace place_recognition
