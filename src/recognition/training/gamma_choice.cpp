#include "recognition/training/gamma_choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace place_recognition {
namespace {

/// Mean off the diagonal; 1 if all features are equal.
double typicalMeasure(const Eigen::MatrixXd& measures) {
  const double n = static_cast<double>(measures.rows());
  const double mean = (measures.sum() - measures.trace()) / std::max(1.0, n * (n - 1));
  return mean > 0 ? mean : 1;
}

}  // namespace

GammaGrid gammaGrid(const Kernel& kernel, const Eigen::MatrixXd& measures) {
  const bool free = kernel.measureIsFreeOfGamma();
  const int powers = free ? 4 : 2;
  GammaGrid grid;
  grid.neutral = free ? 1 / (2 * typicalMeasure(measures)) : 2;
  for (int power = -powers; power <= powers; ++power) {
    grid.gammas.push_back(std::ldexp(grid.neutral, power));
  }
  return grid;
}

double chooseGamma(const std::vector<GammaTrial>& trials, double neutral) {
  assert(!trials.empty());
  const auto lower = [](const GammaTrial& a, const GammaTrial& b) { return a.rate < b.rate; };
  const GammaTrial& best = *std::max_element(trials.begin(), trials.end(), lower);
  const auto distance = [neutral](const GammaTrial& trial) {
    return std::abs(std::log(trial.gamma / neutral));
  };
  const GammaTrial* chosen = &best;
  for (const GammaTrial& trial : trials) {
    const bool as_good = trial.rate >= best.rate - best.standard_error;
    if (as_good && distance(trial) < distance(*chosen)) chosen = &trial;
  }
  return chosen->gamma;
}

}  // namespace place_recognition
