#include "place_recognition/run_sketch.h"

#include <algorithm>
#include <limits>
#include <set>

namespace place_recognition {

void RunSketch::add(std::uint64_t hash) {
  if (hash > limit()) return;
  const auto position = std::lower_bound(hashes_.begin(), hashes_.end(), hash);
  if (position != hashes_.end() && *position == hash) return;
  hashes_.insert(position, hash);
  if (hashes_.size() > kMaxHashes) hashes_.pop_back();
}

std::uint64_t RunSketch::limit() const {
  return hashes_.size() < kMaxHashes ? std::numeric_limits<std::uint64_t>::max() : hashes_.back();
}

bool isLearned(const RunSketch& run, const std::vector<RunSketch>& learned) {
  std::set<std::uint64_t> known;
  for (const RunSketch& other : learned) {
    known.insert(other.hashes().begin(), other.hashes().end());
  }
  return std::any_of(learned.begin(), learned.end(), [&](const RunSketch& other) {
    std::ptrdiff_t images = 0, again = 0;
    for (const std::uint64_t hash : run.hashes()) {
      if (hash > other.limit()) break;
      ++images;
      again += static_cast<std::ptrdiff_t>(known.count(hash));
    }
    return 2 * again > images;
  });
}

}  // namespace place_recognition
