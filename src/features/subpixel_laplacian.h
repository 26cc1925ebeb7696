#pragma once

#include <array>
#include <opencv2/core.hpp>

namespace place_recognition {

/// L_xx + L_yy at one point between the pixels, for images of one size: the Laplacian of the
/// polynomial of degree five in x and in y through the 6 x 6 pixels around the point. Plain
/// differences of neighbours are 6 % too small for a small blob at the first scale of an octave and
/// 2 % at the last, and differ between pixels, which would shift extrema over scale.
class SubpixelLaplacian {
 public:
  static constexpr int kSide = 6;

  /// `place`: in pixels; the centre of the upper left one is (0, 0). `size`: at least 6 x 6.
  SubpixelLaplacian(const cv::Point2d& place, cv::Size size);

  double operator()(const cv::Mat1f& image) const;

 private:
  cv::Point corner_;  ///< the upper left pixel of the 6 x 6
  std::array<double, kSide * kSide> weights_;
};

}  // namespace place_recognition
