#pragma once

#include <vector>

#include "features/gaussian.h"
#include "features/row_ring.h"

namespace place_recognition {

/// Smooths an image that streams through row by row, so that the rows in use stay in the
/// processor's cache. The caller also pushes radius() rows above and below the image; on the left
/// and right the image is mirrored (edge pixels not repeated).
class GaussianFilter {
 public:
  /// Sampled Gaussian of `sigma` > 0 pixels, truncated at `half_width` sigma.
  GaussianFilter(double sigma, double half_width);

  int radius() const { return kernel_.halfWidth(); }
  /// Begins an image.
  void start(int width);
  /// The buffer for the next row, `width` values, written by the caller.
  float* input() { return padded_.data() + radius(); }
  /// Adds the row in input().
  void push();
  /// Filters the row that was pushed radius() rows ago; requires as many rows before it.
  void pull(float* row) const;

 private:
  HalfKernel kernel_;
  int width_ = 0;
  std::vector<float> padded_;  ///< the incoming row, mirrored at both ends
  std::vector<int> mirrored_;  ///< columns for the elements beyond each end, nearest first
  RowRing rows_;               ///< the last 2 radius + 1 rows, smoothed horizontally
};

}  // namespace place_recognition
