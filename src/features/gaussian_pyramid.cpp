#include "features/gaussian_pyramid.h"

#include <algorithm>
#include <cmath>

namespace place_recognition {

namespace {

/// Half-width of the smoothing kernels, in sigma: wide, as errors add up from scale to scale.
constexpr double kHalfWidth = 4;

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

void halve(const cv::Mat1f& in, cv::Mat1f& out) {
  out.create((in.rows + 1) / 2, (in.cols + 1) / 2);
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) out(y, x) = in(2 * y, 2 * x);
  }
}

/// The Gaussian that takes an image from one scale to a larger one.
GaussianFilter filterBetween(double from, double to) {
  return {std::sqrt(to * to - from * from), kHalfWidth};
}

}  // namespace

GaussianPyramid::GaussianPyramid(double finest, int steps, int overlap, int octaves)
    : finest_(finest),
      steps_(steps),
      overlap_(overlap),
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
    }
    for (int s = 1; s < steps_ + overlap_; ++s) smooth(octave[s - 1], filters_[s], octave[s]);
    ++octaves_;
  }
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
