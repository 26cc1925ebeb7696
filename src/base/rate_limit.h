#pragma once

#include <algorithm>
#include <limits>

namespace place_recognition {

/// Thins images out to a number per second, by their stamps. Not thread-safe.
class RateLimit {
 public:
  /// Whether to use the image with `stamp`, s, at `rate` images per second; 0: use all.
  /// Another rate than in the previous call has effect at once.
  bool admits(double stamp, double rate) {
    if (rate <= 0) return true;
    const double period = 1 / rate;
    const double due = used_ + period;
    if (stamp < due) return false;
    // Up to half a period may be caught up, so that late images of a camera with this very rate are
    // not lost.
    used_ = std::max(due, stamp - period / 2);
    return true;
  }

  void reset() { used_ = -std::numeric_limits<double>::infinity(); }

 private:
  // When the last image was used or, if it was late, due; not when the next one is due, because the
  // rate may change.
  double used_ = -std::numeric_limits<double>::infinity();
};

}  // namespace place_recognition
