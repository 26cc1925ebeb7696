#pragma once

#include <algorithm>
#include <cstddef>
#include <opencv2/core/mat.hpp>

namespace place_recognition {

/// The last rows of an image that arrives row by row, stored in order and at equal distances for
/// filters along columns. Each row is stored twice, so that the rows in order are contiguous
/// wherever the oldest is. Only few rows are in use, so that they stay in the processor's cache.
class RowRing {
 public:
  /// Begins an image: allocates its last `rows` rows of `width` numbers.
  void start(int rows, int width) {
    // Rows are an odd number of cache lines apart, so that they do not compete for the same cache
    // sets.
    constexpr int kLine = 64 / sizeof(float);
    const int lines = (width + kLine - 1) / kLine;
    numbers_.create(2 * rows, (lines | 1) * kLine);
    rows_ = rows;
    width_ = width;
    oldest_ = 0;
  }

  /// The buffer for the next row, in place of the oldest.
  float* next() { return numbers_[oldest_]; }
  /// Adds the row in next().
  void push() {
    std::copy_n(numbers_[oldest_], width_, numbers_[oldest_ + rows_]);
    oldest_ = (oldest_ + 1) % rows_;
  }

  /// The row that was pushed `ago` rows before the last. Consecutive rows are step() numbers apart.
  const float* row(int ago) const { return numbers_[oldest_ + rows_ - 1 - ago]; }
  std::ptrdiff_t step() const { return static_cast<std::ptrdiff_t>(numbers_.step1()); }

 private:
  cv::Mat_<float> numbers_;  ///< starts at a cache line, as all memory that OpenCV allocates
  int rows_ = 0;
  int width_ = 0;
  int oldest_ = 0;
};

}  // namespace place_recognition
