#include "place_recognition/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace place_recognition {
namespace {

/// exp(slope (f_k - largest f)), the largest element one.
Eigen::RowVectorXd shares(double slope, const Eigen::RowVectorXd& margins, double largest) {
  // Differences of huge margins may be infinite; the exponential of minus infinity is zero.
  return (slope * (margins.array() - largest)).exp();
}

/// Derivative of the negative log-likelihood by the slope: sum of (p - t)'f over the frames, with
/// targets t. Ascends with the slope, because the likelihood is concave.
double derivative(double slope, const Eigen::MatrixXd& margins, const std::vector<int>& labels) {
  const double places = static_cast<double>(margins.cols());
  const double smoothing = 1 / (static_cast<double>(labels.size()) + places);
  double sum = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Eigen::RowVectorXd f = margins.row(static_cast<Eigen::Index>(i));
    const Eigen::RowVectorXd p = Calibration{slope}.probabilities(f);
    const double wanted = (1 - places * smoothing) * f[labels[i]] + smoothing * f.sum();
    sum += p.dot(f) - wanted;
  }
  return sum;
}

}  // namespace

Eigen::RowVectorXd Calibration::probabilities(const Eigen::RowVectorXd& margins) const {
  const Eigen::RowVectorXd parts = shares(slope, margins, margins.maxCoeff());
  return parts / parts.sum();
}

double Calibration::evidence(const Eigen::RowVectorXd& margins) const {
  const double largest = std::max(0.0, margins.maxCoeff());
  const double sum = shares(slope, margins, largest).sum();
  return sum / (sum + std::exp(-slope * largest));
}

Calibration fitCalibration(const Eigen::MatrixXd& margins, const std::vector<int>& labels) {
  assert(margins.rows() == static_cast<Eigen::Index>(labels.size()));
  const double scale = labels.empty() ? 0 : margins.cwiseAbs().maxCoeff();
  if (scale == 0) return {};
  const Eigen::MatrixXd scaled = margins / scale;
  // Bisection between nearly uniform and nearly certain probabilities; where the margins tell
  // nothing, or the opposite of the truth, it ends at the lower bound.
  double low = std::log(1e-3), high = std::log(1e6);
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (derivative(std::exp(middle), scaled, labels) < 0 ? low : high) = middle;
  }
  return {std::min(std::exp((low + high) / 2) / scale, std::numeric_limits<double>::max())};
}

}  // namespace place_recognition
