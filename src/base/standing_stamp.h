#pragma once

#include <limits>

#include "base/time_jump.h"

namespace place_recognition {

/// Finds stamps that stand still: some drivers give all images the same one. Not thread-safe.
class StandingStamp {
 public:
  /// Whether the images of the last kTimeJump or more, up to this one with `stamp` and `arrival`,
  /// both in s, have the same stamp.
  bool standsStill(double stamp, double arrival) {
    if (stamp != stamp_) {
      stamp_ = stamp;
      since_ = arrival;
    }
    return arrival - since_ >= kTimeJump;
  }

 private:
  double stamp_ = std::numeric_limits<double>::quiet_NaN();
  double since_ = 0;  // the first arrival with this stamp, s
};

}  // namespace place_recognition
