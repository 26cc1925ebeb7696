#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <string>

#include "recognition/frames/light.h"

namespace place_recognition {

/// Normalization of an image's colours for a cue, see CueOptions::normalize.
enum class ColourNormalization { kNone, kBrightness, kGreyWorld, kRun };

/// Throws Error naming the four words if `name`, the value of the option `key`, is none of them.
ColourNormalization colourNormalization(const std::string& name,
                                        const std::string& key = "normalize");

/// Logarithms of the mean levels of blue, green and red; levels count as at least 1. `image`:
/// CV_8UC3 BGR or CV_8UC1, not empty; the three are equal in a grey image. A change of light by one
/// gain per channel adds the logarithms of the gains.
Eigen::RowVector3d logColour(const cv::Mat& image);

/// The change of an image's logColour() in that light.
Eigen::RowVector3d logGains(const Light& light);

/// One image with the colours of each kind of normalization, computed on request and only once. Not
/// thread-safe.
class NormalizedImage {
 public:
  /// Sets `image`, whose logColour() is `colour`; it must stay in memory during use. `correction`:
  /// the gains of kRun, see LightEstimate.
  void set(const cv::Mat& image, const Eigen::RowVector3d& colour, const Light& correction);

  /// kBrightness scales the mean level of all channels to 110; kGreyWorld scales each channel's
  /// mean level to 110 (Buchsbaum 1980).
  const cv::Mat& in(ColourNormalization normalization);
  /// The logarithms of its levels, see takeLogarithms().
  const cv::Mat& logarithms(ColourNormalization normalization);

 private:
  /// An image that is computed on request.
  struct Derived {
    cv::Mat image;
    bool computed = false;
  };

  Light gains(ColourNormalization normalization) const;

  const cv::Mat* image_ = nullptr;
  Eigen::RowVector3d colour_;
  Light correction_;
  std::array<Derived, 4> normalized_, logarithms_;  // by normalization
};

}  // namespace place_recognition
