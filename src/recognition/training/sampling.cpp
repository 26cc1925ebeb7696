#include "recognition/training/sampling.h"

#include <algorithm>
#include <numeric>

namespace place_recognition {
namespace {

std::size_t sumOf(const std::vector<std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// The group with more than one member whose share is largest compared with the exact one.
std::size_t mostFavoured(const std::vector<std::size_t>& shares,
                         const std::vector<std::int64_t>& lacking) {
  std::size_t group = shares.size();
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] > 1 && (group == shares.size() || lacking[k] < lacking[group])) group = k;
  }
  return group;
}

}  // namespace

std::vector<std::size_t> equalShares(const std::vector<std::size_t>& sizes, std::size_t most) {
  const std::size_t all = sumOf(sizes);
  if (all <= most) return sizes;
  std::vector<std::size_t> shares;
  std::vector<std::int64_t> lacking;  // by group: exact minus present share, times `all`
  for (const std::size_t size : sizes) {
    shares.push_back(std::max(size * most / all, std::min<std::size_t>(size, 1)));
    lacking.push_back(static_cast<std::int64_t>(size * most) -
                      static_cast<std::int64_t>(shares.back() * all));
  }
  for (std::size_t total = sumOf(shares); total < most; ++total) {
    const auto group = std::max_element(lacking.begin(), lacking.end()) - lacking.begin();
    ++shares[static_cast<std::size_t>(group)];
    lacking[static_cast<std::size_t>(group)] -= static_cast<std::int64_t>(all);
  }
  for (std::size_t total = sumOf(shares); total > most; --total) {
    const std::size_t group = mostFavoured(shares, lacking);
    if (group == shares.size()) break;
    --shares[group];
    lacking[group] += static_cast<std::int64_t>(all);
  }
  return shares;
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
