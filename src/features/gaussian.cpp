#include "features/gaussian.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace place_recognition {
namespace {

/// Samples at 0..half_width; together with their mirror image they have sum 1.
std::vector<double> sampleGaussian(double t, int half_width) {
  std::vector<double> samples;
  double sum = 0;
  for (int x = 0; x <= half_width; ++x) {
    samples.push_back(std::exp(-x * x / (2 * t)));
    sum += (x == 0 ? 1 : 2) * samples.back();
  }
  for (double& sample : samples) sample /= sum;
  return samples;
}

/// Applies [-1/2 0 1/2] or [1 -2 1] to a symmetric kernel.
std::vector<double> differentiate(const std::vector<double>& g, int order) {
  const int size = static_cast<int>(g.size());
  const auto at = [&](int x) { return std::abs(x) < size ? g[std::abs(x)] : 0; };
  std::vector<double> taps;
  for (int x = 0; x <= size; ++x) {
    taps.push_back(order == 1 ? (at(x - 1) - at(x + 1)) / 2 : at(x - 1) - 2 * at(x) + at(x + 1));
  }
  return taps;
}

/// Derivatives of the Gaussian g at the same samples, x g / t and (x^2 - t) g / t^2, with t and 2
/// t^2 replaced by the corresponding moments of the samples.
std::vector<double> weight(const std::vector<double>& g, int order) {
  double variance = 0, moment4 = 0;
  for (std::size_t x = 1; x < g.size(); ++x) {
    variance += 2 * g[x] * std::pow(x, 2);
    moment4 += 2 * g[x] * std::pow(x, 4);
  }
  std::vector<double> taps;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double x = static_cast<double>(i);
    taps.push_back(order == 1 ? x * g[i] / variance
                              : 2 * (x * x - variance) * g[i] / (moment4 - variance * variance));
  }
  return taps;
}

}  // namespace

int gaussianHalfWidth(double t, double sigmas) {
  return std::max(1, static_cast<int>(std::ceil(sigmas * std::sqrt(t))));
}

HalfKernel gaussianKernel(double t, int half_width, int order, DerivativeMethod method) {
  assert(t > 0 && half_width >= 1 && order >= 0 && order <= 2);
  std::vector<double> taps = sampleGaussian(t, half_width);
  if (order > 0) {
    taps = method == DerivativeMethod::kCentralDifference ? differentiate(taps, order)
                                                          : weight(taps, order);
  }
  return {order, {taps.begin(), taps.end()}};
}

}  // namespace place_recognition
