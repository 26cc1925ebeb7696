#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

#include "place_recognition/depth_extent.h"

namespace place_recognition {

/// The range of an image (CV_16U), without the extreme half percent of its channels at each side.
DepthExtent depthExtentOf(const cv::Mat& image);

/// Brings images of 16 bits per channel to 8 bits. The range that becomes 0 .. 255 is a power of
/// two wide, from zero where images start near it; so the runs of one camera share it although
/// their scenes differ.
class DepthScale {
 public:
  /// By `extent`, whatever the images are; if it is not known, by that of the images seen.
  explicit DepthScale(const DepthExtent& extent = {});

  /// Widens the range, unless it was given.
  void see(const DepthExtent& extent);

  bool isGiven() const { return given_; }
  bool hasSeen() const { return width_ > 0; }
  const DepthExtent& extent() const { return extent_; }

  /// `image` itself if it is CV_8U; sees one of CV_16U and returns it in CV_8U, saturated.
  cv::Mat toEightBits(const cv::Mat& image);

  /// For a person, as in "0 .. 1023 of 16 bits", with "as in training" if the range was given; once
  /// hasSeen().
  std::string text() const;

 private:
  void setRange();

  DepthExtent extent_;
  bool given_;
  std::uint32_t start_ = 0;  // of the range
  std::uint32_t width_ = 0;  // of the range, a power of two; 0: no image was seen
};

}  // namespace place_recognition
