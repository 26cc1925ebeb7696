#pragma once

#include <vector>

#include "features/gaussian.h"
#include "features/row_ring.h"

namespace place_recognition {

/// Smooths an image that streams through row by row, so that what it works on stays in the
/// processor's cache. The caller sends the rows above and below the image too, radius() of each;
/// to the left and right the image is mirrored (edge pixels not repeated).
class GaussianFilter {
 public:
  /// Sampled Gaussian of `sigma` > 0 pixels, cut at `half_width` sigma.
  GaussianFilter(double sigma, double half_width);

  int radius() const { return kernel_.halfWidth(); }
  /// Begins an image.
  void start(int width);
  /// Where the caller writes the next row, `width` values.
  float* input() { return padded_.data() + radius(); }
  /// Takes in the row at input().
  void push();
  /// Filters the row that was pushed radius() rows ago; needs as many rows before it.
  void pull(float* row) const;

 private:
  HalfKernel kernel_;
  int width_ = 0;
  std::vector<float> padded_;  ///< the row that comes in, mirrored at both ends
  std::vector<int> mirrored_;  ///< columns for the elements beyond each end, nearest first
  RowRing rows_;               ///< the last 2 radius + 1, smoothed along themselves
};

}  // namespace place_recognition
