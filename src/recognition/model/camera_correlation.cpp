#include "place_recognition/camera_correlation.h"

#include <algorithm>

namespace place_recognition {
namespace {

double meanOfPairs(const CameraCorrelation& learned) {
  const auto count = static_cast<double>(learned.cameras.size());
  if (count < 2) return kUnknownCorrelation;
  return (learned.coefficients.sum() - count) / (count * (count - 1));
}

}  // namespace

Eigen::MatrixXd coefficientsFor(const std::vector<std::string>& cameras,
                                const CameraCorrelation& learned) {
  const auto count = static_cast<Eigen::Index>(cameras.size());
  std::vector<Eigen::Index> known;  // by camera: its index in `learned`; -1: not in it
  for (const std::string& camera : cameras) {
    const auto found = std::find(learned.cameras.begin(), learned.cameras.end(), camera);
    known.push_back(found == learned.cameras.end() ? -1 : found - learned.cameras.begin());
  }
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Constant(count, count, meanOfPairs(learned));
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      const Eigen::Index i = known[static_cast<std::size_t>(a)];
      const Eigen::Index j = known[static_cast<std::size_t>(b)];
      if (i >= 0 && j >= 0) coefficients(a, b) = learned.coefficients(i, j);
      if (a == b) coefficients(a, b) = 1;
    }
  }
  return coefficients;
}

}  // namespace place_recognition
