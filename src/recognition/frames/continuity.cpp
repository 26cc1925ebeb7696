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
    continues_ = may_continue_ && frame.stamp > last_stamps_[camera] && followsClosely(frame.stamp);
    if (!continues_) {
      last_stamps_.assign(cameras_.size(), -std::numeric_limits<double>::infinity());
      begin_ = frame.stamp;
      moments_ = 0;
    }
  }
  last_stamps_[camera] = frame.stamp;
  moments_ += 1.0 / static_cast<double>(cameras_.size());
  return first && !continues_;
}

bool Continuity::followsClosely(double stamp) const {
  const double end = *std::max_element(last_stamps_.begin(), last_stamps_.end());
  const double interval = moments_ > 1 ? (end - begin_) / (moments_ - 1) : 0;
  return std::abs(stamp - end) <= largestGapOfParts(interval);
}

}  // namespace place_recognition
