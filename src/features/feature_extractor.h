#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Maps an image to a feature. An extractor owns its buffers and reuses them from frame to frame:
/// use one per thread.
class FeatureExtractor {
 public:
  virtual ~FeatureExtractor() = default;

  /// Extracts the feature of `image` (CV_8UC3 in BGR order, or CV_8UC1 grey; at least 1 x 1) into
  /// `feature`, reusing its memory. Sets std::monostate if the image has no such feature (too
  /// small, too few interest points); missingReason() then says why.
  virtual void extract(const cv::Mat& image, Feature& feature) = 0;

  /// Why the last extract() gave no feature: for a person, without a full stop.
  const std::string& missingReason() const { return missing_reason_; }

 protected:
  std::string missing_reason_;
};

/// Builds the extractor that `options` describe. Throws Error if an option is out of range.
std::unique_ptr<FeatureExtractor> makeFeatureExtractor(const FeatureOptions& options);

}  // namespace place_recognition
