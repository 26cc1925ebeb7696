#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <string>

#include "recognition/frames/light.h"

namespace place_recognition {

/// What is done to the colours of an image before a cue looks at it, see CueOptions::normalize.
enum class ColourNormalization { kNone, kBrightness, kGreyWorld, kRun };

/// Throws Error naming the four words if `name` is none of them.
ColourNormalization colourNormalization(const std::string& name);

/// Logarithm of the mean level of each channel: blue, green, red. `image`: CV_8UC3 BGR or CV_8UC1,
/// not empty; in a grey one the three are equal. A change of light by a gain per channel adds the
/// logarithms of the gains. Levels count as 1 at least.
Eigen::RowVector3d logColour(const cv::Mat& image);

/// What an image's logColor() grows by in that light.
Eigen::RowVector3d logGains(const Light& light);

/// One image in the colours that each kind of normalization gives it, made when asked for and once.
/// Not thread-safe.
class NormalizedImage {
 public:
  /// `image`, of logColor() `color`, stays where it is while this is used. `correction`: what kRun
  /// multiplies by, see LightEstimate.
  void set(const cv::Mat& image, const Eigen::RowVector3d& colour, const Light& correction);

  /// kBrightness: the mean level of all channels is 110. kGreyWorld: that of each channel is
  /// (Buchsbaum 1980).
  const cv::Mat& in(ColourNormalization normalization);

 private:
  Light gains(ColourNormalization normalization) const;

  const cv::Mat* image_ = nullptr;
  Eigen::RowVector3d colour_;
  Light correction_;
  std::array<cv::Mat, 4> made_;  // by normalization
  std::array<bool, 4> is_made_{};
};

}  // namespace place_recognition
