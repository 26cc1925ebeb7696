#include "place_recognition/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace place_recognition {
namespace {

/// slope * margins, kept so far from infinity that differences stay finite.
Eigen::RowVectorXd exponents(double slope, const Eigen::RowVectorXd& margins) {
  constexpr double kLargest = 1e300;
  return (slope * margins).cwiseMax(-kLargest).cwiseMin(kLargest);
}

/// exp(z_k) / sum_j exp(z_j).
Eigen::RowVectorXd softmax(const Eigen::RowVectorXd& z) {
  const Eigen::RowVectorXd powers = (z.array() - z.maxCoeff()).exp();
  return powers / powers.sum();
}

/// Derivative of the negative log-likelihood with respect to the slope: expected less wanted
/// margins. It rises with the slope, for the likelihood is log-concave.
double slopeGradient(double slope, const Eigen::MatrixXd& margins, double wanted_sum) {
  const Eigen::VectorXd largest = margins.rowwise().maxCoeff();
  const Eigen::ArrayXXd powers = (slope * (margins.colwise() - largest)).array().exp();
  const Eigen::ArrayXd expected =
      (powers * margins.array()).rowwise().sum() / powers.rowwise().sum();
  return expected.sum() - wanted_sum;
}

/// Sum over frames of the margins expected under the wanted probabilities.
double wantedSum(const Eigen::MatrixXd& margins, const std::vector<int>& labels) {
  const auto frames = static_cast<double>(labels.size());
  double true_margins = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    true_margins += margins(static_cast<Eigen::Index>(i), labels[i]);
  }
  const double mean_margins = margins.sum() / static_cast<double>(margins.cols());
  return (frames * true_margins + mean_margins) / (frames + 1);
}

/// The element that a `share` of the values lie below.
double quantile(Eigen::VectorXd values, double share) {
  std::sort(values.data(), values.data() + values.size());
  const auto below = static_cast<Eigen::Index>(share * static_cast<double>(values.size()));
  return values[std::min(below, values.size() - 1)];
}

/// One over the standard deviation; 0 where all values are equal.
double unitsOf(const Eigen::VectorXd& values) {
  const double deviation = std::sqrt((values.array() - values.mean()).square().mean());
  return deviation > 1e-9 * (1 + values.cwiseAbs().maxCoeff()) ? 1 / deviation : 0;
}

}  // namespace

Eigen::RowVectorXd Calibration::probabilities(const Eigen::RowVectorXd& margins) const {
  return softmax(exponents(slope, margins));
}

double Calibration::logSum(const Eigen::RowVectorXd& margins) const {
  const Eigen::RowVectorXd z = exponents(slope, margins);
  const double largest = z.maxCoeff();
  return largest + std::log((z.array() - largest).exp().sum());
}

double Calibration::logOdds(const Eigen::RowVectorXd& margins, double familiarity) const {
  return weights.margins * logSum(margins) + weights.familiarity * familiarity + weights.offset;
}

double Calibration::evidence(const Eigen::RowVectorXd& margins, double familiarity) const {
  return 1 / (1 + std::exp(-logOdds(margins, familiarity)));
}

Calibration fitCalibration(const Eigen::MatrixXd& margins, const std::vector<int>& labels) {
  assert(margins.rows() == static_cast<Eigen::Index>(labels.size()));
  if (labels.empty()) return {};
  // For margins of at most 1. The flattest slope is for margins that tell nothing or the opposite.
  constexpr double kFlattest = 1e-3;
  constexpr double kSteepest = 1e12;
  const double largest = margins.cwiseAbs().maxCoeff();
  const double scale = largest > 0 ? largest : 1;
  const Eigen::MatrixXd scaled = margins / scale;
  const double wanted = wantedSum(scaled, labels);

  double low = kFlattest;
  double high = kFlattest;
  while (high < kSteepest && slopeGradient(high, scaled, wanted) < 0) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (slopeGradient(middle, scaled, wanted) < 0 ? low : high) = middle;
  }
  Calibration calibration;
  calibration.slope = high / scale;
  return calibration;
}

EvidenceWeights fitEvidence(const Eigen::VectorXd& log_sums, const Eigen::VectorXd& familiarity,
                            double share) {
  assert(log_sums.size() == familiarity.size());
  if (log_sums.size() == 0) return {};
  EvidenceWeights weights;
  weights.margins = unitsOf(log_sums);
  weights.familiarity = unitsOf(familiarity);
  const Eigen::VectorXd sums = weights.margins * log_sums + weights.familiarity * familiarity;
  const double limit = quantile(sums, share);
  const double spread = quantile(sums, 0.5) - limit;
  constexpr double kMedian = 3;  // 1 / (1 + exp(-3)) = 0.95
  const double gain = spread > 0 ? kMedian / spread : 1;
  weights.margins *= gain;
  weights.familiarity *= gain;
  weights.offset = -gain * limit;
  return weights;
}

}  // namespace place_recognition
