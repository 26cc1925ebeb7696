#pragma once

#include <algorithm>
#include <limits>

namespace place_recognition {

/// Thins images out to a number each second, by their stamps. Not thread-safe.
class RateLimit {
 public:
  /// Whether the image of `stamp`, s, is to be used at `rate` images each second; 0: all are.
  bool admits(double stamp, double rate) {
    if (rate <= 0) return true;
    if (stamp < due_) return false;
    const double period = 1 / rate;
    // Half a period may be caught up, so that a camera of just this rate loses no late image.
    due_ = std::max(due_, stamp - period / 2) + period;
    return true;
  }

  void reset() { due_ = -std::numeric_limits<double>::infinity(); }

 private:
  double due_ = -std::numeric_limits<double>::infinity();  // stamp of the next image to be used
};

}  // namespace place_recognition
