#pragma once

#include <mutex>
#include <optional>

#include "place_recognition/temporal_filter.h"

namespace place_recognition {

/// A pose from odometry.
struct OdometryPose {
  double stamp = 0;  ///< s
  double x = 0;      ///< m
  double y = 0;      ///< m
  double yaw = 0;    ///< rad
};

/// Accumulates the path between poses of odometry, for TemporalFilter. Thread-safe.
class OdometryAccumulator {
 public:
  /// Ignores poses that are not finite, and steps that no robot makes. After such a step, or a
  /// stamp before the last one, the path starts anew.
  void add(const OdometryPose& pose);

  /// The path since the last call. Nothing if no pose is close to `stamp`, s, or if the path
  /// started anew since the last call.
  std::optional<Motion> take(double stamp);

 private:
  std::mutex mutex_;  // guards everything below
  std::optional<OdometryPose> last_;
  Motion way_;             // since the last take()
  bool unbroken_ = false;  // no new start since the last take()
};

}  // namespace place_recognition
