#include "features/gaussian_filter.h"

#include <opencv2/core.hpp>

#include "features/row_kernels.h"

namespace place_recognition {

GaussianFilter::GaussianFilter(double sigma, double half_width)
    : kernel_(gaussianKernel(sigma * sigma, gaussianHalfWidth(sigma * sigma, half_width))) {}

void GaussianFilter::start(int width) {
  rows_.start(2 * radius() + 1, width);
  if (width == width_) return;
  width_ = width;
  padded_.resize(width + 2 * radius());
  mirrored_.clear();
  for (int i = 1; i <= radius(); ++i) {
    mirrored_.push_back(cv::borderInterpolate(-i, width, cv::BORDER_REFLECT_101));
    mirrored_.push_back(cv::borderInterpolate(width - 1 + i, width, cv::BORDER_REFLECT_101));
  }
}

void GaussianFilter::push() {
  float* row = input();
  for (int i = 1; i <= radius(); ++i) {
    row[-i] = row[mirrored_[2 * i - 2]];
    row[width_ - 1 + i] = row[mirrored_[2 * i - 1]];
  }
  correlate(row, 1, kernel_, width_, rows_.next());
  rows_.push();
}

void GaussianFilter::pull(float* row) const {
  correlate(rows_.row(radius()), rows_.step(), kernel_, width_, row);
}

}  // namespace place_recognition
