#include "recognition/frames/continuity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_recognition {

void Continuity::begin(const std::vector<std::string>& cameras) {
  may_continue_ = !starts_ && cameras == cameras_;
  cameras_ = cameras;
  starts_ = true;
  continues_ = false;
}

bool Continuity::beginsStream(const Frame& frame) {
  const auto camera = static_cast<std::size_t>(frame.camera);
  const bool first = starts_;
  starts_ = false;
  if (first) {
    continues_ = may_continue_ && frame.stamp > last_stamps_[camera] &&
                 std::abs(frame.stamp - *std::max_element(last_stamps_.begin(),
                                                          last_stamps_.end())) <= kMaxGapOfParts;
    if (!continues_) {
      last_stamps_.assign(cameras_.size(), -std::numeric_limits<double>::infinity());
    }
  }
  last_stamps_[camera] = frame.stamp;
  return first && !continues_;
}

}  // namespace place_recognition
