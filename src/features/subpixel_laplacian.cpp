#include "features/subpixel_laplacian.h"

#include <algorithm>
#include <cmath>

namespace place_recognition {

namespace {

constexpr int kSide = SubpixelLaplacian::kSide;

/// Weights of the samples at 0, 1, .. 5 in the value and the second derivative, at `t`, of the
/// polynomial through them (Lagrange's form: the weight of sample i is prod (t - j) / (i - j)).
void lagrangeWeights(double t, std::array<double, kSide>& value,
                     std::array<double, kSide>& second_derivative) {
  for (int i = 0; i < kSide; ++i) {
    // Value, first and second derivative of the product, factor by factor.
    double v = 1, d = 0, dd = 0;
    for (int j = 0; j < kSide; ++j) {
      if (j == i) continue;
      const double slope = 1.0 / (i - j);
      const double factor = (t - j) * slope;
      dd = dd * factor + 2 * d * slope;
      d = d * factor + v * slope;
      v *= factor;
    }
    value[i] = v;
    second_derivative[i] = dd;
  }
}

/// The first of the six pixels around `place` along a side of `size` pixels.
int firstPixel(double place, int size) {
  return std::clamp(static_cast<int>(std::floor(place)) - kSide / 2 + 1, 0, size - kSide);
}

}  // namespace

SubpixelLaplacian::SubpixelLaplacian(const cv::Point2d& place, cv::Size size)
    : corner_(firstPixel(place.x, size.width), firstPixel(place.y, size.height)) {
  std::array<double, kSide> x_value, x_second, y_value, y_second;
  lagrangeWeights(place.x - corner_.x, x_value, x_second);
  lagrangeWeights(place.y - corner_.y, y_value, y_second);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      weights_[y * kSide + x] = x_second[x] * y_value[y] + x_value[x] * y_second[y];
    }
  }
}

double SubpixelLaplacian::operator()(const cv::Mat1f& image) const {
  double sum = 0;
  for (int y = 0; y < kSide; ++y) {
    const float* row = image[corner_.y + y] + corner_.x;
    for (int x = 0; x < kSide; ++x) sum += weights_[y * kSide + x] * row[x];
  }
  return sum;
}

}  // namespace place_recognition
