#pragma once

#include <vector>

namespace place_recognition {

/// Method for derivatives of a sampled image.
enum class DerivativeMethod {
  kCentralDifference,  ///< Smooth, then correlate with [-1/2 0 1/2] or [1 -2 1].
  kGaussian,           ///< Correlate with a sampled derivative of the Gaussian, eq. 4.10.
};

/// Half of a one-dimensional correlation kernel that is even or odd: taps[0] is its centre and
/// taps[r] its value at +r; the value at -r is the same, or the negative if `order` is 1. The sum
/// of a kernel of order 2 is exactly zero, regardless of rounding.
struct HalfKernel {
  int order = 0;  ///< Order of the derivative: 0, 1 or 2.
  std::vector<float> taps;

  int halfWidth() const { return static_cast<int>(taps.size()) - 1; }
};

/// Half-width in pixels of the sampled Gaussian of variance t > 0: `sigmas` standard deviations,
/// rounded up, and at least 1.
int gaussianHalfWidth(double t, double sigmas);

/// The kernel that smooths with the Gaussian of variance t (thesis eq. 4.3 in one dimension,
/// sampled -half_width..half_width, sum 1) and takes the derivative of the given order, 0, 1 or 2.
/// Exact for parabolas with both methods: order 1 gives 1 on x; order 2 gives 2 on x^2. Central
/// differences make it wider by 1.
HalfKernel gaussianKernel(double t, int half_width, int order = 0,
                          DerivativeMethod method = DerivativeMethod::kGaussian);

}  // namespace place_recognition
