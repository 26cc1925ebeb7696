#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

#include "place_recognition/level_range.h"

namespace place_recognition {

/// The range of an image (CV_16U), without the extreme half per cent of its channel values at each
/// end.
LevelRange levelRangeOf(const cv::Mat& image);

/// Converts images with 16 bits per channel to 8 bits. The width of the window that becomes 0..255
/// is a power of two, and the window starts at zero if the images start near it. The runs of one
/// camera therefore share a window although their scenes differ.
class LevelScale {
 public:
  /// Uses `range`, whatever the images contain; if it is not known, the range of the images seen.
  explicit LevelScale(const LevelRange& range = {});

  /// Widens the range, unless it was given.
  void see(const LevelRange& range);

  bool hasSeen() const { return width_ > 0; }
  const LevelRange& range() const { return range_; }

  /// `image` itself if it is CV_8U; an image of CV_16U is seen and returned in CV_8U, saturated.
  cv::Mat toEightBits(const cv::Mat& image);

  /// The window for a person, such as "0 .. 1023 of 16 bits", followed by "as in training" if it
  /// was given. Requires hasSeen().
  std::string text() const;

 private:
  void setWindow();

  LevelRange range_;
  bool given_;
  std::uint32_t start_ = 0;  // of the window
  std::uint32_t width_ = 0;  // of the window, a power of two; 0: no image seen
};

}  // namespace place_recognition
