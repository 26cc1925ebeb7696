#include "recognition/training/log_loss.h"

#include <algorithm>
#include <cmath>

#include "place_recognition/calibration.h"

namespace place_recognition {
namespace {

constexpr double kSmallestProbability = 1e-3;

Calibration calibrationOf(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                          const std::vector<int>& chosen) {
  std::vector<int> labels;
  Eigen::MatrixXd margins(static_cast<Eigen::Index>(chosen.size()), held_out.margins.cols());
  for (const int i : chosen) {
    if (!held_out.valid[static_cast<std::size_t>(i)]) continue;
    margins.row(static_cast<Eigen::Index>(labels.size())) = held_out.margins.row(i);
    labels.push_back(samples[static_cast<std::size_t>(i)].place);
  }
  return fitCalibration(margins.topRows(static_cast<Eigen::Index>(labels.size())), labels);
}

}  // namespace

std::vector<double> logLosses(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                              const std::vector<int>& chosen) {
  const Calibration calibration = calibrationOf(held_out, samples, chosen);
  std::vector<double> losses;
  for (const int i : chosen) {
    const double probability = calibration.probabilities(
        held_out.margins.row(i))[samples[static_cast<std::size_t>(i)].place];
    losses.push_back(-std::log(std::max(kSmallestProbability, probability)));
  }
  return losses;
}

}  // namespace place_recognition
