#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "features/gaussian_filter.h"

namespace place_recognition {

/// A Gaussian scale space (thesis section 4.1) in octaves. Scales are numbered: sigma(n) = finest *
/// 2^(n / steps), in pixels of the image. Octave o has every 2^o-th pixel of every 2^o-th row at
/// the `steps` scales from number o * steps on and, overlapping the next octave, at `overlap` more.
/// Pixel x of octave o lies at x * 2^o in the image; the upper left pixel's centre is (0, 0).
class GaussianPyramid {
 public:
  /// `finest` > kCameraBlur; `octaves` at most: fewer in small images, but at least one.
  GaussianPyramid(double finest, int steps, int overlap, int octaves);

  /// `image`: not empty, taken to have been blurred by kCameraBlur already.
  void build(const cv::Mat1f& image);

  int octaves() const { return octaves_; }
  /// How many scales there are, numbered from 0.
  int scales() const { return octaves_ * steps_ + overlap_; }
  /// In pixels of the image; in pixels of octave o, sigma(n) is sigma(n - o * steps).
  double sigma(int scale) const;
  /// The number nearest to `sigma` (pixels of the image).
  int nearestScale(double sigma) const;
  /// The finest octave that has the scale.
  int octaveOf(int scale) const;
  /// The image of a scale in an octave that has it.
  const cv::Mat1f& level(int octave, int scale) const {
    return levels_[octave][scale - octave * steps_];
  }

  static constexpr double kCameraBlur = 0.5;  ///< sigma, pixels (Lowe 2004)
  static constexpr int kSmallestSide = 12;    ///< pixels; smaller octaves are not built

 private:
  double finest_;
  int steps_;
  int overlap_;
  int octaves_ = 0;
  std::vector<GaussianFilter> filters_;         ///< of each step, from the step before
  std::vector<std::vector<cv::Mat1f>> levels_;  ///< by octave and step
};

}  // namespace place_recognition
