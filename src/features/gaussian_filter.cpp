#include "features/gaussian_filter.h"

#include <algorithm>
#include <cstddef>
#include <opencv2/core.hpp>

#include "features/row_kernels.h"

namespace place_recognition {

GaussianFilter::GaussianFilter(double sigma, double half_width)
    : kernel_(gaussianKernel(sigma * sigma, gaussianHalfWidth(sigma * sigma, half_width))) {}

void GaussianFilter::start(int width) {
  if (width == width_) return;
  width_ = width;
  padded_.resize(width + 2 * radius());
  rows_.resize(static_cast<std::size_t>(2) * (2 * radius() + 1) * width);
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
  const int count = 2 * radius() + 1;
  float* slot = rows_.data() + static_cast<std::size_t>(oldest_) * width_;
  correlate(row, 1, kernel_, width_, slot);
  std::copy_n(slot, width_, slot + static_cast<std::size_t>(count) * width_);
  oldest_ = (oldest_ + 1) % count;
}

void GaussianFilter::pull(float* row) const {
  const auto middle = static_cast<std::size_t>(oldest_ + radius()) * width_;
  correlate(rows_.data() + middle, width_, kernel_, width_, row);
}

}  // namespace place_recognition
