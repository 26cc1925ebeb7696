#pragma once

#include <mutex>
#include <optional>

#include "place_recognition/temporal_filter.h"

namespace place_recognition {

/// A pose as odometry tells it.
struct OdometryPose {
  double stamp = 0;  ///< s
  double x = 0;      ///< m
  double y = 0;      ///< m
  double yaw = 0;    ///< rad
};

/// Adds up the way between the poses of odometry, for TemporalFilter. Thread-safe.
class OdometryAccumulator {
 public:
  /// Poses that are not numbers are left out, as are steps that no robot makes: after those, or a
  /// stamp before the last one, counting starts anew.
  void add(const OdometryPose& pose);

  /// The way since the last call. Nothing if no pose is near `stamp`, s, or counting has started
  /// since.
  std::optional<Motion> take(double stamp);

 private:
  std::mutex mutex_;  // of all below
  std::optional<OdometryPose> last_;
  Motion way_;             // since the last take()
  bool unbroken_ = false;  // counted without a break since the last take()
};

}  // namespace place_recognition
