#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

#include "place_recognition/depth_extent.h"

namespace place_recognition {

/// The range of an image (CV_16U), without the extreme half per cent of its channel values at each
/// end.
DepthExtent depthExtentOf(const cv::Mat& image);

/// Converts images with 16 bits per channel to 8 bits. The width of the range that becomes 0..255
/// is a power of two, and the range starts at zero if the images start near it. The runs of one
/// camera therefore share a range although their scenes differ.
class DepthScale {
 public:
  /// Uses `extent`, whatever the images contain; if it is not known, the extent of the images seen.
  explicit DepthScale(const DepthExtent& extent = {});

  /// Widens the range, unless it was given.
  void see(const DepthExtent& extent);

  bool hasSeen() const { return width_ > 0; }
  const DepthExtent& extent() const { return extent_; }

  /// `image` itself if it is CV_8U; an image of CV_16U is seen and returned in CV_8U, saturated.
  cv::Mat toEightBits(const cv::Mat& image);

  /// The range for a person, such as "0 .. 1023 of 16 bits", followed by "as in training" if it was
  /// given. Requires hasSeen().
  std::string text() const;

 private:
  void setRange();

  DepthExtent extent_;
  bool given_;
  std::uint32_t start_ = 0;  // of the range
  std::uint32_t width_ = 0;  // of the range, a power of two; 0: no image seen
};

}  // namespace place_recognition
