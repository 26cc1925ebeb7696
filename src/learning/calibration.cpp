#include "place_recognition/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "base/quantile.h"

namespace place_recognition {
namespace {

/// slope * decision values, clamped so that differences stay finite.
Eigen::RowVectorXd exponents(double slope, const Eigen::RowVectorXd& decision_values) {
  constexpr double kLargest = 1e300;
  return (slope * decision_values).cwiseMax(-kLargest).cwiseMin(kLargest);
}

/// exp(z_k) / sum_j exp(z_j).
Eigen::RowVectorXd softmax(const Eigen::RowVectorXd& z) {
  const Eigen::RowVectorXd powers = (z.array() - z.maxCoeff()).exp();
  return powers / powers.sum();
}

/// Derivative of the negative log-likelihood with respect to the slope: expected minus target
/// decision values. It increases with the slope because the likelihood is log-concave.
double slopeGradient(double slope, const Eigen::MatrixXd& decision_values, double wanted_sum) {
  const Eigen::VectorXd largest = decision_values.rowwise().maxCoeff();
  const Eigen::ArrayXXd powers = (slope * (decision_values.colwise() - largest)).array().exp();
  const Eigen::ArrayXd expected =
      (powers * decision_values.array()).rowwise().sum() / powers.rowwise().sum();
  return expected.sum() - wanted_sum;
}

/// Sum over frames of the decision values expected under the target probabilities.
double wantedSum(const Eigen::MatrixXd& decision_values, const std::vector<int>& labels) {
  const auto frames = static_cast<double>(labels.size());
  double true_values = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    true_values += decision_values(static_cast<Eigen::Index>(i), labels[i]);
  }
  const double mean_values = decision_values.sum() / static_cast<double>(decision_values.cols());
  return (frames * true_values + mean_values) / (frames + 1);
}

/// One over the standard deviation; 0 if all values are equal.
double unitsOf(const Eigen::VectorXd& values) {
  const double deviation = std::sqrt((values.array() - values.mean()).square().mean());
  return deviation > 1e-9 * (1 + values.cwiseAbs().maxCoeff()) ? 1 / deviation : 0;
}

}  // namespace

Eigen::RowVectorXd Calibration::probabilities(const Eigen::RowVectorXd& decision_values) const {
  return softmax(exponents(slope, decision_values));
}

double Calibration::logSum(const Eigen::RowVectorXd& decision_values) const {
  const Eigen::RowVectorXd z = exponents(slope, decision_values);
  const double largest = z.maxCoeff();
  return largest + std::log((z.array() - largest).exp().sum());
}

double Calibration::logOdds(const Eigen::RowVectorXd& decision_values, double familiarity) const {
  return weights.decision_values * logSum(decision_values) + weights.familiarity * familiarity +
         weights.offset;
}

double Calibration::evidence(const Eigen::RowVectorXd& decision_values, double familiarity) const {
  return logistic(logOdds(decision_values, familiarity));
}

Calibration fitCalibration(const Eigen::MatrixXd& decision_values, const std::vector<int>& labels) {
  assert(decision_values.rows() == static_cast<Eigen::Index>(labels.size()));
  if (labels.empty()) return {};
  // For decision values of at most 1. The flattest slope is for decision values that carry no
  // information or the opposite.
  constexpr double kFlattest = 1e-3;
  constexpr double kSteepest = 1e12;
  const double largest = decision_values.cwiseAbs().maxCoeff();
  const double scale = largest > 0 ? largest : 1;
  const Eigen::MatrixXd scaled = decision_values / scale;
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
                            double fraction) {
  assert(log_sums.size() == familiarity.size());
  if (log_sums.size() == 0) return {};
  EvidenceWeights weights;
  weights.decision_values = unitsOf(log_sums);
  weights.familiarity = unitsOf(familiarity);
  const Eigen::VectorXd sums =
      weights.decision_values * log_sums + weights.familiarity * familiarity;
  const std::vector<double> values(sums.data(), sums.data() + sums.size());
  const double limit = quantile(values, fraction);
  const double spread = median(values) - limit;
  constexpr double kMedian = 3;  // 1 / (1 + exp(-3)) = 0.95
  const double gain = spread > 0 ? kMedian / spread : 1;
  weights.decision_values *= gain;
  weights.familiarity *= gain;
  weights.offset = -gain * limit;
  return weights;
}

}  // namespace place_recognition
