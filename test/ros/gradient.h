#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace place_recognition {

/// An image of `type`, CV_8UC3 or CV_8UC1, without sharp edges.
inline cv::Mat gradient(int type) {
  cv::Mat image(24, 32, type);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols * image.channels(); ++x) {
      image.ptr(y)[x] = static_cast<std::uint8_t>(3 * x / image.channels() + 4 * y);
    }
  }
  return image;
}

}  // namespace place_recognition
