#include "recognition/over_time/odometry_accumulator.h"

#include <cmath>

namespace place_recognition {
namespace {

/// Odometry further from an image than this, s, is not used for it.
constexpr double kNear = 0.5;
/// A faster step, m/s, means that odometry was set to another pose.
constexpr double kMaxSpeed = 10;

bool isFinite(const OdometryPose& pose) {
  return std::isfinite(pose.stamp) && std::isfinite(pose.x) && std::isfinite(pose.y) &&
         std::isfinite(pose.yaw);
}

}  // namespace

void OdometryAccumulator::add(const OdometryPose& pose) {
  if (!isFinite(pose)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (last_) {
    const double elapsed = pose.stamp - last_->stamp;
    const double distance = std::hypot(pose.x - last_->x, pose.y - last_->y);
    if (elapsed >= 0 && distance <= kMaxSpeed * elapsed) {
      way_.distance += distance;
      way_.angle += std::abs(std::remainder(pose.yaw - last_->yaw, 2 * M_PI));
    } else {
      unbroken_ = false;
    }
  }
  last_ = pose;
}

std::optional<Motion> OdometryAccumulator::take(double stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool near = last_ && std::abs(stamp - last_->stamp) <= kNear;
  const bool complete = near && unbroken_;
  const Motion way = way_;
  way_ = Motion();
  unbroken_ = near;
  if (!complete) return std::nullopt;
  return way;
}

}  // namespace place_recognition
