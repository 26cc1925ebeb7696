#include "features/gaussian_pyramid.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"

namespace place_recognition {

namespace {

/// Half-width of the smoothing kernels, in sigma; wide, because errors add up from scale to scale.
constexpr double kHalfWidth = 4;

bool isOdd(int n) { return n % 2 == 1; }

void smooth(const cv::Mat1f& in, GaussianFilter& filter, cv::Mat1f& out) {
  out.create(in.size());
  filter.start(in.cols);
  for (int y = -filter.radius(); y < in.rows + filter.radius(); ++y) {
    const float* row = in[cv::borderInterpolate(y, in.rows, cv::BORDER_REFLECT_101)];
    std::copy_n(row, in.cols, filter.input());
    filter.push();
    if (y >= filter.radius()) filter.pull(out[y - filter.radius()]);
  }
}

/// Values halfway between rows b and c, from the cubic through four rows. Its second moment is
/// zero, so it does not blur.
PLACE_RECOGNITION_TARGET_CLONES
void interpolateRows(const float* a, const float* b, const float* c, const float* d, int width,
                     float* __restrict out) {
  for (int x = 0; x < width; ++x) out[x] = (9 * (b[x] + c[x]) - (a[x] + d[x])) / 16;
}

/// Halves the number of rows symmetrically: from an odd number, every other row; from an even
/// number, the values halfway between two rows.
void halveRows(const cv::Mat1f& in, cv::Mat1f& out) {
  out.create((in.rows + 1) / 2, in.cols);
  for (int y = 0; y < out.rows; ++y) {
    if (isOdd(in.rows)) {
      std::copy_n(in[2 * y], in.cols, out[y]);
    } else {
      const int before = std::max(2 * y - 1, 0), after = std::min(2 * y + 2, in.rows - 1);
      interpolateRows(in[before], in[2 * y], in[2 * y + 1], in[after], in.cols, out[y]);
    }
  }
}

/// The Gaussian that smooths an image from one scale to a larger one.
GaussianFilter filterBetween(double from, double to) {
  return {std::sqrt(to * to - from * from), kHalfWidth};
}

}  // namespace

GaussianPyramid::GaussianPyramid(double finest, int steps, int overlap, int octaves)
    : finest_(finest),
      steps_(steps),
      overlap_(overlap),
      origins_(octaves),
      levels_(octaves, std::vector<cv::Mat1f>(steps + overlap)) {
  filters_.push_back(filterBetween(kCameraBlur, finest));
  for (int s = 1; s < steps + overlap; ++s) {
    filters_.push_back(filterBetween(sigma(s - 1), sigma(s)));
  }
}

void GaussianPyramid::build(const cv::Mat1f& image) {
  smooth(image, filters_[0], levels_[0][0]);
  octaves_ = 0;
  for (std::vector<cv::Mat1f>& octave : levels_) {
    if (octaves_ > 0) {
      const cv::Mat1f& finer = levels_[octaves_ - 1][steps_];
      if (std::min(finer.cols, finer.rows) < 2 * kSmallestSide) return;
      halve(finer, octave[0]);
      const double half_pixel = 0.5 * std::exp2(octaves_ - 1);
      origins_[octaves_] = origins_[octaves_ - 1] + cv::Point2d(isOdd(finer.cols) ? 0 : half_pixel,
                                                                isOdd(finer.rows) ? 0 : half_pixel);
    }
    for (int s = 1; s < steps_ + overlap_; ++s) smooth(octave[s - 1], filters_[s], octave[s]);
    ++octaves_;
  }
}

void GaussianPyramid::halve(const cv::Mat1f& in, cv::Mat1f& out) {
  halveRows(in, halved_);
  cv::transpose(halved_, transposed_);
  halveRows(transposed_, halved_);
  cv::transpose(halved_, out);
}

double GaussianPyramid::sigma(int scale) const {
  return finest_ * std::exp2(static_cast<double>(scale) / steps_);
}

int GaussianPyramid::nearestScale(double sigma) const {
  const int scale = static_cast<int>(std::lround(steps_ * std::log2(sigma / finest_)));
  return std::clamp(scale, 0, scales() - 1);
}

int GaussianPyramid::octaveOf(int scale) const { return std::max(0, scale - overlap_) / steps_; }

}  // namespace place_recognition
