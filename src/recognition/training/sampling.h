#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "base/rate_limit.h"

namespace place_recognition {

/// Thins the frames of a recording out to a number per second, by their stamps. If stamps do not
/// increase from frame to frame, all frames are kept.
class FrameRate {
 public:
  /// Frames per second; 0: all.
  explicit FrameRate(double rate) : rate_(rate) {}

  /// Whether to use the next frame of the recording, with `stamp`, s.
  bool admits(double stamp) {
    if (stamp <= last_) limit_.reset();
    last_ = stamp;
    return limit_.admits(stamp, rate_);
  }

 private:
  double rate_;
  RateLimit limit_;
  double last_ = -std::numeric_limits<double>::infinity();
};

/// How many members to keep of groups with these `sizes` so that there are at most `most` in total:
/// the same fraction of each, rounded by the largest remainder, but at least one of each group,
/// even if that makes more than `most`.
std::vector<std::size_t> equalShares(const std::vector<std::size_t>& sizes, std::size_t most);

/// Selects at most `counts[k]` samples of group k by stratified sampling: the group is divided into
/// as many intervals of equal length, and one sample is drawn from each. A fixed step could
/// coincide with a period, such as a tripod's angles. `groups`: by sample, an index into `counts`.
std::vector<bool> stratifiedSample(const std::vector<int>& groups,
                                   const std::vector<std::size_t>& counts, std::uint64_t seed);

/// The same with equalShares() of the groups: all samples if there are no more than `most`.
std::vector<bool> stratifiedSample(const std::vector<int>& groups, std::size_t most,
                                   std::uint64_t seed);

/// Thins a stream of unknown length out to one of every `step` members, drawn at random except for
/// the first, which is always kept.
class StratifiedStream {
 public:
  StratifiedStream(std::size_t step, std::uint64_t seed) : step_(step), random_(seed) {}

  /// Whether to keep the next member.
  bool keepsNext();

 private:
  std::size_t step_;
  std::mt19937_64 random_;
  std::size_t seen_ = 0;
  std::size_t drawn_ = 0;  // in the current interval
};

}  // namespace place_recognition
