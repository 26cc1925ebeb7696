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
  return (frames * true_margins + margins.sum()) / (frames + static_cast<double>(margins.cols()));
}

}  // namespace

Eigen::RowVectorXd Calibration::probabilities(const Eigen::RowVectorXd& margins) const {
  return softmax(exponents(slope, margins));
}

double Calibration::evidence(const Eigen::RowVectorXd& margins) const {
  Eigen::RowVectorXd with_none(margins.size() + 1);
  with_none << margins, 0;
  return softmax(exponents(slope, with_none)).head(margins.size()).sum();
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
  return {high / scale};
}

}  // namespace place_recognition
