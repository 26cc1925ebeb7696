#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "features/gaussian_filter.h"

namespace place_recognition {

/// A Gaussian scale space (thesis section 4.1) in octaves. Scales are numbered: sigma(n) = finest *
/// 2^(n / steps), in pixels of the image. Octave o has samples 2^o pixels apart, at the `steps`
/// scales from number o * steps on and at `overlap` more, which the next octave also has. The
/// samples lie symmetrically in the image, so that an image turned by 90 degrees or mirrored has
/// the same samples.
class GaussianPyramid {
 public:
  /// `finest` > kCameraBlur. `octaves` is a maximum: small images have fewer, but at least one.
  GaussianPyramid(double finest, int steps, int overlap, int octaves);

  /// `image` must not be empty; it is assumed to have a blur of kCameraBlur.
  void build(const cv::Mat1f& image);

  int octaves() const { return octaves_; }
  /// Number of scales, numbered from 0.
  int scales() const { return octaves_ * steps_ + overlap_; }
  /// In pixels of the image; in pixels of octave o, sigma(n) is sigma(n - o * steps).
  double sigma(int scale) const;
  /// The number nearest to `sigma` (pixels of the image).
  int nearestScale(double sigma) const;
  /// The finest octave that contains the scale.
  int octaveOf(int scale) const;
  /// Converts a point of the image to samples of an octave, and back. The centres of the upper left
  /// pixel and of the upper left sample are at (0, 0).
  cv::Point2d toOctave(int octave, const cv::Point2d& place) const {
    return (place - origins_[octave]) * std::exp2(-octave);
  }
  cv::Point2d toImage(int octave, const cv::Point2d& place) const {
    return origins_[octave] + place * std::exp2(octave);
  }
  /// The image of a scale in an octave that contains it.
  const cv::Mat1f& level(int octave, int scale) const {
    return levels_[octave][scale - octave * steps_];
  }

  static constexpr double kCameraBlur = 0.5;  ///< sigma, pixels (Lowe 2004)
  static constexpr int kSmallestSide = 12;    ///< pixels; there are no smaller octaves

 private:
  void halve(const cv::Mat1f& in, cv::Mat1f& out);

  double finest_;
  int steps_;
  int overlap_;
  int octaves_ = 0;
  std::vector<cv::Point2d> origins_;            ///< upper left sample of each octave, in the image
  std::vector<GaussianFilter> filters_;         ///< of each step, from the step before
  std::vector<std::vector<cv::Mat1f>> levels_;  ///< by octave and step
  cv::Mat1f halved_;
  cv::Mat1f transposed_;
};

}  // namespace place_recognition
