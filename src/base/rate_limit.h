#pragma once

#include <algorithm>
#include <limits>

namespace place_recognition {

/// Thins images out to a number per second, by their stamps. Not thread-safe.
class RateLimit {
 public:
  /// Whether to use the image with `stamp`, s, at `rate` images per second; 0: use all.
  bool admits(double stamp, double rate) {
    if (rate <= 0) return true;
    if (stamp < due_) return false;
    const double period = 1 / rate;
    // Up to half a period may be caught up, so that late images of a camera with this very rate are
    // not lost.
    due_ = std::max(due_, stamp - period / 2) + period;
    return true;
  }

  void reset() { due_ = -std::numeric_limits<double>::infinity(); }

 private:
  double due_ = -std::numeric_limits<double>::infinity();  // stamp of the next image to use
};

}  // namespace place_recognition
