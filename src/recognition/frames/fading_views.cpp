#include "recognition/frames/fading_views.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/time_jump.h"

namespace place_recognition {
namespace {

constexpr double kFadingTime = 300;  // s
constexpr double kViewsOfAPlace = 5;
constexpr double kNewFrame = 1;  // s, spacing of frames that count in full

}  // namespace

FadingViews::FadingViews(Eigen::Index places, Eigen::Index values)
    : counts_(Eigen::VectorXd::Zero(places)), sums_(Eigen::MatrixXd::Zero(places, values)) {}

void FadingViews::reset() {
  started_ = false;
  counts_.setZero();
  sums_.setZero();
}

void FadingViews::beginFrame(double stamp) {
  const double elapsed = stamp - stamp_;
  if (started_ && !(elapsed >= -kTimeJump)) reset();
  fraction_ = started_ ? std::clamp(elapsed / kNewFrame, 0.0, 1.0) : 1;
  if (started_ && elapsed > 0) {
    const double kept = std::exp(-elapsed / kFadingTime);
    counts_ *= kept;
    sums_ *= kept;
  }
  stamp_ = stamp;
  started_ = true;
}

void FadingViews::add(const Eigen::RowVectorXd& probabilities, const Eigen::MatrixXd& values) {
  assert(probabilities.size() == counts_.size());
  assert(values.rows() == sums_.rows() && values.cols() == sums_.cols());
  for (Eigen::Index k = 0; k < counts_.size(); ++k) {
    const double part = fraction_ * probabilities[k];
    counts_[k] += part;
    sums_.row(k) += part * values.row(k);
  }
}

Eigen::VectorXd FadingViews::fractions() const {
  return (1 + counts_.array() / kViewsOfAPlace).inverse();
}

}  // namespace place_recognition
