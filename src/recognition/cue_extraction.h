#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/feature_extractor.h"
#include "place_recognition/training_options.h"
#include "recognition/color_normalization.h"

namespace place_recognition {

/// `image`, or if it is wider than `max_width` > 0 pixels, a copy of that width in `buffer`.
const cv::Mat& scaledDown(const cv::Mat& image, int max_width, cv::Mat& buffer);

/// The road from an image to the feature of each cue, the same in training and in recognition: the
/// image is scaled down to its greatest width, its colours are normalized, then each cue's
/// extractor looks at it. Keeps its buffers from image to image: one a thread.
class CueExtraction {
 public:
  explicit CueExtraction(const TrainingOptions& options);

  /// Features of `image` (CV_8UC3 BGR or CV_8UC1, not empty), one a cue, into `features`, whose
  /// memory is reused. False if no cue could be extracted; reason() then says why.
  /// `light`: what cues that follow the light of the run multiply the image by.
  bool extract(const cv::Mat& image, std::vector<Feature>& features, const Light& light = {});

  /// logColor() of the last image, before any normalization; zero if no cue normalizes.
  const Eigen::RowVector3d& color() const { return color_; }

  const std::string& reason() const { return reason_; }

 private:
  int max_width_;
  std::vector<std::unique_ptr<FeatureExtractor>> extractors_;
  std::vector<ColorNormalization> normalizations_;  // of each cue
  cv::Mat scaled_;
  bool normalizes_ = false;
  Eigen::RowVector3d color_ = Eigen::RowVector3d::Zero();
  NormalizedImage normalized_;
  std::string reason_;
};

}  // namespace place_recognition
