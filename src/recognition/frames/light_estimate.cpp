#include "recognition/frames/light_estimate.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "place_recognition/calibration.h"

namespace place_recognition {
namespace {

constexpr double kOddsOfChange = 1.0 / 3;
constexpr double kKnownWithin = 0.15;  // standard deviation at which certainty is one half
constexpr double kNoise = 0.01;        // standard deviation of the same view between frames

/// G: brightness varies by a standard deviation of 0.5 in its logarithm, and each channel
/// separately by 15 %.
Eigen::Matrix3d changesOfLight() {
  return Eigen::Matrix3d::Constant(0.5 * 0.5) + 0.15 * 0.15 * Eigen::Matrix3d::Identity();
}

}  // namespace

LightEstimate::LightEstimate(const ColourStatistics& training)
    : training_(training), views_(training.means.rows(), 3) {
  if (!training_.known()) return;
  precision_ = (training_.covariance + kNoise * kNoise * Eigen::Matrix3d::Identity()).inverse();
  estimate();
}

void LightEstimate::reset() {
  views_.reset();
  if (training_.known()) estimate();
}

void LightEstimate::beginFrame(double stamp) {
  if (!training_.known()) return;
  views_.beginFrame(stamp);
  estimate();
}

void LightEstimate::add(const Eigen::RowVector3d& colour, const Eigen::RowVectorXd& probabilities) {
  if (!training_.known()) return;
  views_.add(probabilities, (-training_.means).rowwise() + colour);
  estimate();
}

void LightEstimate::estimate() {
  const Eigen::Matrix3d known = precision_ * views_.views();            // P
  const Eigen::Vector3d pull = precision_ * views_.sums().transpose();  // b
  const Eigen::Matrix3d prior = changesOfLight();
  const Eigen::Matrix3d covariance = (known + prior.inverse()).inverse();
  const Eigen::Vector3d change = covariance * pull;
  const double determinant = (Eigen::Matrix3d::Identity() + prior * known).determinant();
  const double log_odds =
      std::log(kOddsOfChange) - std::log(determinant) / 2 + pull.dot(change) / 2;
  const double changed = logistic(log_odds);
  const double variance =
      changed * covariance.trace() / 3 + changed * (1 - changed) * change.squaredNorm() / 3;
  certainty_ = 1 / (1 + variance / (kKnownWithin * kKnownWithin));
  const Eigen::Vector3d gains = (-changed * change).array().exp();
  correction_ = {gains[2], gains[1], gains[0]};
}

}  // namespace place_recognition
