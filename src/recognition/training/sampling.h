#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "base/rate_limit.h"

namespace place_recognition {

/// Thins the frames of a recording out to a number each second, by their stamps. Where stamps do
/// not grow from frame to frame they tell nothing, and all frames are taken.
class FrameRate {
 public:
  /// Frames a second; 0: all.
  explicit FrameRate(double rate) : rate_(rate) {}

  /// Whether the next frame of the recording, of `stamp` in s, is to be used.
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

/// How many members to keep of groups of these `sizes` so that there are no more than `most` (and
/// one of each group): of each the same fraction.
std::vector<std::size_t> equalShares(const std::vector<std::size_t>& sizes, std::size_t most);

/// Which samples to keep so that there are at most `counts[k]` of group k, by stratified sampling.
/// The group is cut into as many stretches of equal length as are kept of it, and one sample is
/// drawn from each: a fixed step would hit the period of a tripod's angles. `groups`: of each
/// sample, an index into `counts`.
std::vector<bool> stratifiedSample(const std::vector<int>& groups,
                                   const std::vector<std::size_t>& counts, std::uint64_t seed);

/// The same with equalShares() of the groups: all samples if they are no more than `most`.
std::vector<bool> stratifiedSample(const std::vector<int>& groups, std::size_t most,
                                   std::uint64_t seed);

/// Thins a stream out to one of every `step` members of a group, drawn at random but for the first,
/// which always is the group's first member. For streams whose length is not known.
class StratifiedStream {
 public:
  StratifiedStream(std::size_t step, std::uint64_t seed) : step_(step), random_(seed) {}

  /// Whether the next member is kept.
  bool keepsNext();

 private:
  std::size_t step_;
  std::mt19937_64 random_;
  std::size_t seen_ = 0;
  std::size_t drawn_ = 0;  // of the current stretch
};

}  // namespace place_recognition
