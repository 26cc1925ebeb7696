#include "place_recognition/camera_correlation.h"

#include <algorithm>

namespace place_recognition {
namespace {

double meanOfPairs(const CameraCorrelation& learnt) {
  const auto count = static_cast<double>(learnt.cameras.size());
  if (count < 2) return kUnknownCorrelation;
  return (learnt.coefficients.sum() - count) / (count * (count - 1));
}

}  // namespace

Eigen::MatrixXd coefficientsFor(const std::vector<std::string>& cameras,
                                const CameraCorrelation& learnt) {
  const auto count = static_cast<Eigen::Index>(cameras.size());
  std::vector<Eigen::Index> known;  // of each camera, its number in `learnt`; -1: it is new
  for (const std::string& camera : cameras) {
    const auto found = std::find(learnt.cameras.begin(), learnt.cameras.end(), camera);
    known.push_back(found == learnt.cameras.end() ? -1 : found - learnt.cameras.begin());
  }
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Constant(count, count, meanOfPairs(learnt));
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      const Eigen::Index i = known[static_cast<std::size_t>(a)];
      const Eigen::Index j = known[static_cast<std::size_t>(b)];
      if (i >= 0 && j >= 0) coefficients(a, b) = learnt.coefficients(i, j);
      if (a == b) coefficients(a, b) = 1;
    }
  }
  return coefficients;
}

}  // namespace place_recognition
