#include "recognition/frames/light_estimate.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace place_recognition {
namespace {

constexpr double kFadingTime = 300;  // s
constexpr double kViewsOfAPlace = 5;
constexpr double kNewFrame = 1;  // s, from one frame to the next that counts in full
constexpr double kTimeJump = 1;  // s, back: a new stream
constexpr double kOddsOfChange = 1.0 / 3;
constexpr double kKnownWithin = 0.15;  // standard deviation that halves the certainty
constexpr double kNoise = 0.01;        // standard deviation of the same view from frame to frame

/// G: brightness changes by half its logarithm, each channel apart by 15 %.
Eigen::Matrix3d changesOfLight() {
  return Eigen::Matrix3d::Constant(0.5 * 0.5) + 0.15 * 0.15 * Eigen::Matrix3d::Identity();
}

}  // namespace

LightEstimate::LightEstimate(const ColorStatistics& training) : training_(training) {
  if (!training_.known()) return;
  precision_ = (training_.covariance + kNoise * kNoise * Eigen::Matrix3d::Identity()).inverse();
  reset();
}

void LightEstimate::reset() {
  started_ = false;
  if (!training_.known()) return;
  counts_.setZero(training_.means.rows());
  sums_.setZero(training_.means.rows(), 3);
  estimate();
}

void LightEstimate::beginFrame(double stamp) {
  if (!training_.known()) return;
  const double elapsed = stamp - stamp_;
  if (started_ && !(elapsed >= -kTimeJump)) reset();
  share_ = started_ ? std::clamp(elapsed / kNewFrame, 0.0, 1.0) : 1;
  if (started_ && elapsed > 0) {
    const double kept = std::exp(-elapsed / kFadingTime);
    counts_ *= kept;
    sums_ *= kept;
    estimate();
  }
  stamp_ = stamp;
  started_ = true;
}

void LightEstimate::add(const Eigen::RowVector3d& color, const Eigen::RowVectorXd& probabilities) {
  if (!training_.known()) return;
  assert(probabilities.size() == training_.means.rows());
  for (Eigen::Index k = 0; k < counts_.size(); ++k) {
    const double part = share_ * probabilities[k];
    counts_[k] += part;
    sums_.row(k) += part * (color - training_.means.row(k));
  }
  estimate();
}

void LightEstimate::estimate() {
  Eigen::Matrix3d known = Eigen::Matrix3d::Zero();  // P
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();   // b
  for (Eigen::Index k = 0; k < counts_.size(); ++k) {
    if (counts_[k] <= 0) continue;
    const Eigen::Matrix3d precision = precision_ / (1 / counts_[k] + 1 / kViewsOfAPlace);
    known += precision;
    pull += precision * (sums_.row(k) / counts_[k]).transpose();
  }
  const Eigen::Matrix3d prior = changesOfLight();
  const Eigen::Matrix3d covariance = (known + prior.inverse()).inverse();
  const Eigen::Vector3d change = covariance * pull;
  const double determinant = (Eigen::Matrix3d::Identity() + prior * known).determinant();
  const double log_odds =
      std::log(kOddsOfChange) - std::log(determinant) / 2 + pull.dot(change) / 2;
  const double changed = 1 / (1 + std::exp(-log_odds));
  const double variance =
      changed * covariance.trace() / 3 + changed * (1 - changed) * change.squaredNorm() / 3;
  certainty_ = 1 / (1 + variance / (kKnownWithin * kKnownWithin));
  const Eigen::Vector3d gains = (-changed * change).array().exp();
  correction_ = {gains[2], gains[1], gains[0]};
}

}  // namespace place_recognition
