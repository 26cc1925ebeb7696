#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "base/rate_limit.h"

namespace place_recognition {

/// Thins the frames of a run out to a number each second, by their stamps. Where stamps do not grow
/// from frame to frame they tell nothing, and all frames are taken.
class FrameRate {
 public:
  /// Frames a second; 0: all.
  explicit FrameRate(double rate) : rate_(rate) {}

  /// Whether the next frame of the run, of `stamp` in s, is to be used.
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

/// Which of the samples to keep so that there are no more than `most` (and one of each group): of
/// each group the same share, evenly over it. `groups`: of each sample, 0 or more.
std::vector<bool> evenShare(const std::vector<int>& groups, std::size_t most);

}  // namespace place_recognition
