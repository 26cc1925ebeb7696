#include "features/gaussian.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_recognition {
namespace {

/// Returns the sum over x of kernel(x) x^power.
double moment(const HalfKernel& kernel, int power) {
  double sum = power == 0 && kernel.order != 1 ? kernel.taps[0] : 0;
  for (int x = 1; x <= kernel.halfWidth(); ++x) {
    const double mirrored = (kernel.order == 1 ? -1 : 1) * (power % 2 == 1 ? -1 : 1);
    sum += kernel.taps[x] * (1 + mirrored) * std::pow(x, power);
  }
  return sum;
}

TEST(Gaussian, HalfWidthIsRoundedUpAndAtLeastOne) {
  EXPECT_EQ(gaussianHalfWidth(1, 3), 3);
  EXPECT_EQ(gaussianHalfWidth(2, 3), 5);
  EXPECT_EQ(gaussianHalfWidth(21, 3), 14);
  EXPECT_EQ(gaussianHalfWidth(0.01, 3), 1);
}

TEST(Gaussian, KernelsAreExactForParabolas) {
  for (double t : {0.3, 1.0, 4.0, 50.0}) {
    const int half = gaussianHalfWidth(t, 3);
    EXPECT_NEAR(moment(gaussianKernel(t, half), 0), 1, 1e-6);
    for (auto method : {DerivativeMethod::kCentralDifference, DerivativeMethod::kGaussian}) {
      EXPECT_NEAR(moment(gaussianKernel(t, half, 1, method), 1), 1, 1e-6);
      EXPECT_NEAR(moment(gaussianKernel(t, half, 2, method), 0), 0, 1e-6);
      EXPECT_NEAR(moment(gaussianKernel(t, half, 2, method), 2), 2, 1e-5);
    }
  }
}

TEST(Gaussian, CentralDifferencesAreThoseOfTheSmoothingKernel) {
  const auto method = DerivativeMethod::kCentralDifference;
  const HalfKernel g = gaussianKernel(2, 5, 0), first = gaussianKernel(2, 5, 1, method),
                   second = gaussianKernel(2, 5, 2, method);
  EXPECT_EQ(first.halfWidth(), 6);
  EXPECT_FLOAT_EQ(first.taps[0], 0);
  EXPECT_FLOAT_EQ(first.taps[2], (g.taps[1] - g.taps[3]) / 2);  // Correlation: mirrored.
  EXPECT_FLOAT_EQ(first.taps[6], g.taps[5] / 2);
  EXPECT_FLOAT_EQ(second.taps[0], 2 * (g.taps[1] - g.taps[0]));
  EXPECT_FLOAT_EQ(second.taps[6], g.taps[5]);
}

TEST(Gaussian, SamplesFollowTheFormula) {
  const double t = 6.25;
  const HalfKernel smooth = gaussianKernel(t, 15, 0), first = gaussianKernel(t, 15, 1),
                   second = gaussianKernel(t, 15, 2);
  for (int x = 0; x <= 15; ++x) {  // Wide enough for the sums to be the integrals.
    const double g = std::exp(-x * x / (2 * t)) / std::sqrt(2 * M_PI * t);
    EXPECT_NEAR(smooth.taps[x], g, 1e-7);
    EXPECT_NEAR(first.taps[x], x / t * g, 1e-7);  // Correlation: -g'(x).
    EXPECT_NEAR(second.taps[x], (x * x / t - 1) / t * g, 1e-7);
  }
}

}  // namespace
}  // namespace place_recognition
