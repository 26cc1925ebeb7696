#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace place_recognition {

/// Brings images of 16 bits a channel to 8 bits. Infrared, thermal and machine vision cameras use
/// 10 to 14 of the 16 bits, so that the upper byte alone would leave a few levels of grey. The
/// range that becomes 0 .. 255 is a power of two wide, from zero where images start near it, and
/// widens with the images that were seen; so the runs of one camera share it although their scenes
/// differ.
class DepthScale {
 public:
  /// Widens the range to hold all but the extreme half percent of the channels of `image` (CV_16U).
  void see(const cv::Mat& image);

  bool hasSeen() const { return width_ > 0; }

  /// `image` itself if it is CV_8U; of CV_16U sees it and returns it in CV_8U, saturated.
  cv::Mat toEightBits(const cv::Mat& image);

  /// For a person, as in "0 .. 1023 of 16 bits"; once an image was seen.
  std::string text() const;

 private:
  std::uint32_t low_ = 0;    // percentiles of all images seen
  std::uint32_t high_ = 0;   // likewise
  std::uint32_t start_ = 0;  // of the range
  std::uint32_t width_ = 0;  // of the range, a power of two; 0: no image was seen
};

}  // namespace place_recognition
