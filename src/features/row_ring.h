#pragma once

#include <algorithm>
#include <cstddef>
#include <opencv2/core/mat.hpp>

namespace place_recognition {

/// The last rows of an image that comes row by row, in order and at equal distances, as filters
/// down its columns read them. Each stands there twice, so that wherever the oldest is, all follow
/// it; and few of them are in use at a time, so that they stay in the processor's cache.
class RowRing {
 public:
  /// Begins an image: room for its last `rows` rows of `width` numbers.
  void start(int rows, int width) {
    // An odd number of cache lines apart, so that the rows are not put in the same places of it.
    constexpr int kLine = 64 / sizeof(float);
    const int lines = (width + kLine - 1) / kLine;
    numbers_.create(2 * rows, (lines | 1) * kLine);
    rows_ = rows;
    width_ = width;
    oldest_ = 0;
  }

  /// Where the next row is to be written, in place of the oldest.
  float* next() { return numbers_[oldest_]; }
  /// Takes in the row at next().
  void push() {
    std::copy_n(numbers_[oldest_], width_, numbers_[oldest_ + rows_]);
    oldest_ = (oldest_ + 1) % rows_;
  }

  /// The row that was pushed `ago` rows before the last. From a row to the next one it is step()
  /// numbers.
  const float* row(int ago) const { return numbers_[oldest_ + rows_ - 1 - ago]; }
  std::ptrdiff_t step() const { return static_cast<std::ptrdiff_t>(numbers_.step1()); }

 private:
  cv::Mat_<float> numbers_;  ///< begins at a cache line, as all memory that OpenCV gives
  int rows_ = 0;
  int width_ = 0;
  int oldest_ = 0;
};

}  // namespace place_recognition
