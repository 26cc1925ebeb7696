#include "recognition/training/halving_sample.h"

#include <limits>
#include <random>

namespace place_recognition {
namespace {

/// A random bit from `seed` for each pair in a round of a tournament.
bool drawnBit(std::uint64_t seed, int round, std::uint64_t pair) {
  std::seed_seq words{seed, seed >> 32, pair, pair >> 32, static_cast<std::uint64_t>(round)};
  return std::mt19937(words)() & 1;
}

}  // namespace

int StratifiedLevels::next() {
  const std::uint64_t member = seen_++;
  if (member == 0) return std::numeric_limits<int>::max();
  int level = 0;
  for (;; ++level) {
    const std::uint64_t pair = member >> level >> 1;
    const bool is_second = member >> level & 1;
    const bool second_wins = pair > 0 && drawnBit(seed_, level, pair);
    if (is_second != second_wins) break;
  }
  return level;
}

std::optional<int> HalvingSample::next(const std::string& place) {
  const std::uint64_t seed = seed_ + places_.size();
  const int level =
      places_.try_emplace(place, Place{StratifiedLevels(seed)}).first->second.levels.next();
  if (!keeps(place, level)) return std::nullopt;
  return level;
}

bool HalvingSample::keeps(const std::string& place, int level) {
  if (level >= least_level_) return true;
  ++places_.at(place).left_out;
  return false;
}

std::size_t HalvingSample::leftOut(const std::string& place) const {
  const auto found = places_.find(place);
  return found == places_.end() ? 0 : found->second.left_out;
}

}  // namespace place_recognition
