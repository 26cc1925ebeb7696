#pragma once

#include <opencv2/core.hpp>

#include "features/feature_extractor.h"
#include "features/harris_laplace.h"
#include "features/sift_descriptor.h"
#include "place_recognition/local_feature_options.h"

namespace place_recognition {

/// SIFT descriptors at Harris-Laplace interest points, strongest first: a DescriptorSet.
class LocalFeatureExtractor : public FeatureExtractor {
 public:
  /// Throws Error if an option is out of range.
  explicit LocalFeatureExtractor(const LocalFeatureOptions& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  void describe(const InterestPoint& point, std::vector<std::uint8_t>& descriptors);

  LocalFeatureOptions options_;
  HarrisLaplace detector_;
  SiftDescriptor sift_;
  cv::Mat converted_;
  cv::Mat1f image_;
};

}  // namespace place_recognition
