#include "features/gaussian.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace place_recognition {

int gaussianHalfWidth(double t, double sigmas) {
  return std::max(1, static_cast<int>(std::ceil(sigmas * std::sqrt(t))));
}

HalfKernel gaussianKernel(double t, int half_width, int order) {
  assert(t > 0 && half_width >= 1 && order >= 0 && order <= 2);
  // Moments of the truncated samples; on paper they are 1, t and 3 t^2.
  double moment0 = 0, moment2 = 0, moment4 = 0;
  const auto gaussian = [t](double x) { return std::exp(-x * x / (2 * t)); };
  for (int x = -half_width; x <= half_width; ++x) {
    const double g = gaussian(x), x2 = x * x;
    moment0 += g;
    moment2 += g * x2;
    moment4 += g * x2 * x2;
  }
  const double variance = moment2 / moment0;

  HalfKernel kernel;
  kernel.order = order;
  for (int x = 0; x <= half_width; ++x) {
    const double g = gaussian(x);
    double tap = g / moment0;
    if (order == 1) tap = x * g / moment2;
    if (order == 2) tap = 2 * (x * x - variance) * g / (moment4 - variance * moment2);
    kernel.taps.push_back(static_cast<float>(tap));
  }
  return kernel;
}

}  // namespace place_recognition
