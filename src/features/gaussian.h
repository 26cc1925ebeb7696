#pragma once

#include <vector>

namespace place_recognition {

/// Half of a one-dimensional kernel that is its own mirror image but for the sign: taps[0] is its
/// centre and taps[r] its value at +r (at -r too, or the negative of it at -r if `order` is 1).
struct HalfKernel {
  int order = 0;  ///< Order of the derivative that it takes: 0, 1 or 2.
  std::vector<float> taps;

  int halfWidth() const { return static_cast<int>(taps.size()) - 1; }
};

/// Half-width in pixels of the sampled Gaussian of variance t > 0: `sigmas` standard deviations,
/// rounded up, and at least 1.
int gaussianHalfWidth(double t, double sigmas);

/// The sampled Gaussian of variance t (thesis eq. 4.3 in one dimension), normalised to sum 1, or
/// its derivative of order 1 or 2 (eq. 4.10), normalised so that it is exact for parabolas:
/// order 1 gives 1 on x, order 2 gives 0 on constants and 2 on x^2.
HalfKernel gaussianKernel(double t, int half_width, int order = 0);

}  // namespace place_recognition
