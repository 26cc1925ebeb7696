#include "place_recognition/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace place_recognition {
namespace {

using Array = Eigen::ArrayXd;

/// 1 / (1 + exp(slope f + offset)).
struct Sigmoid {
  double slope;
  double offset;

  Array exponents(const Array& margins) const { return slope * margins + offset; }
};

/// The flattest sigmoid that may be fitted, for margins of at most 1. It keeps a place whose
/// margins tell nothing, or the opposite of the truth, from reversing their order.
constexpr double kFlattest = -1e-3;

/// log(1 + exp(z)) without overflow.
double softplus(double z) { return std::max(z, 0.0) + std::log1p(std::exp(-std::abs(z))); }

/// Cross-entropy of the sigmoid against the targets t in (0, 1): sum of t z + log(1 + exp(-z)).
double crossEntropy(const Sigmoid& sigmoid, const Array& margins, const Array& targets) {
  const Array z = sigmoid.exponents(margins);
  return (targets * z + (-z).unaryExpr(&softplus)).sum();
}

/// Platt's smoothed targets: as if one more frame of either kind had been seen.
Array smoothedTargets(const std::vector<int>& labels, int place, double* prior_offset) {
  const auto positive = static_cast<double>(std::count(labels.begin(), labels.end(), place));
  const double negative = static_cast<double>(labels.size()) - positive;
  Array targets(static_cast<Eigen::Index>(labels.size()));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    targets[static_cast<Eigen::Index>(i)] =
        labels[i] == place ? (positive + 1) / (positive + 2) : 1 / (negative + 2);
  }
  *prior_offset = std::log((negative + 1) / (positive + 1));
  return targets;
}

/// Newton's method with backtracking from `sigmoid` (Lin, Lin and Weng 2007, algorithm 1), on the
/// offset alone or on both parameters.
Sigmoid minimise(Sigmoid sigmoid, bool slope_free, const Array& margins, const Array& targets) {
  constexpr int kMaxSteps = 100;
  constexpr double kRidge = 1e-12;
  constexpr double kShortestStep = 1e-10;
  const double tolerance = 1e-10 * static_cast<double>(margins.size());
  double loss = crossEntropy(sigmoid, margins, targets);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Array p = 1 / (1 + sigmoid.exponents(margins).exp());
    const Array curvature = p * (1 - p);
    const double slope_gradient = slope_free ? (margins * (targets - p)).sum() : 0;
    const double offset_gradient = (targets - p).sum();
    if (std::abs(slope_gradient) < tolerance && std::abs(offset_gradient) < tolerance) break;

    const double h11 = (margins.square() * curvature).sum() + kRidge;
    const double h22 = curvature.sum() + kRidge;
    const double h12 = slope_free ? (margins * curvature).sum() : 0;
    const double determinant = h11 * h22 - h12 * h12;
    const double slope_step = (h12 * offset_gradient - h22 * slope_gradient) / determinant;
    const double offset_step = (h12 * slope_gradient - h11 * offset_gradient) / determinant;
    const double descent = slope_gradient * slope_step + offset_gradient * offset_step;

    double length = 1;
    for (; length >= kShortestStep; length /= 2) {
      const Sigmoid next{sigmoid.slope + length * slope_step,
                         sigmoid.offset + length * offset_step};
      const double next_loss = crossEntropy(next, margins, targets);
      if (next_loss < loss + 1e-4 * length * descent) {
        sigmoid = next;
        loss = next_loss;
        break;
      }
    }
    if (length < kShortestStep) break;
  }
  return sigmoid;
}

Sigmoid fitSigmoid(const Array& margins, const std::vector<int>& labels, int place) {
  const double largest = margins.size() > 0 ? margins.abs().maxCoeff() : 0;
  const double scale = largest > 0 ? largest : 1;
  const Array scaled = margins / scale;
  double prior_offset = 0;
  const Array targets = smoothedTargets(labels, place, &prior_offset);
  Sigmoid sigmoid = minimise({0, prior_offset}, true, scaled, targets);
  if (!(sigmoid.slope <= kFlattest)) {
    sigmoid = minimise({kFlattest, prior_offset}, false, scaled, targets);
  }
  sigmoid.slope /= scale;
  return sigmoid;
}

}  // namespace

Eigen::RowVectorXd Calibration::sigmoids(const Eigen::RowVectorXd& margins) const {
  return 1 / (1 + (slopes.array() * margins.array() + offsets.array()).exp());
}

Eigen::RowVectorXd Calibration::probabilities(const Eigen::RowVectorXd& margins) const {
  // In logarithms, because all sigmoids may underflow; a product may overflow to infinity.
  constexpr double kLargest = 1e300;
  const Eigen::ArrayXXd z =
      (slopes.array() * margins.array() + offsets.array()).max(-kLargest).min(kLargest);
  const Eigen::ArrayXXd logs = -z.unaryExpr(&softplus);
  const Eigen::ArrayXXd shares = (logs - logs.maxCoeff()).exp();
  return shares / shares.sum();
}

Calibration fitCalibration(const Eigen::MatrixXd& margins, const std::vector<int>& labels) {
  assert(margins.rows() == static_cast<Eigen::Index>(labels.size()));
  Calibration calibration;
  calibration.slopes.resize(margins.cols());
  calibration.offsets.resize(margins.cols());
  for (Eigen::Index place = 0; place < margins.cols(); ++place) {
    const Sigmoid sigmoid = fitSigmoid(margins.col(place), labels, static_cast<int>(place));
    calibration.slopes[place] = sigmoid.slope;
    calibration.offsets[place] = sigmoid.offset;
  }
  return calibration;
}

}  // namespace place_recognition
