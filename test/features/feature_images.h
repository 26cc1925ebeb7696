#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <variant>
#include <vector>

#include "features/feature_extractor.h"

namespace place_recognition {

/// Returns the feature of an image as `Vector`, its kind, and expects that it has one.
template <typename Vector>
Vector extractAs(const cv::Mat& image, const FeatureOptions& options) {
  Feature feature;
  const auto extractor = makeFeatureExtractor(options);
  extractor->extract(image, feature);
  EXPECT_EQ(extractor->missingReason(), "");
  return std::get<Vector>(feature);
}

inline SparseVector extractSparse(const cv::Mat& image, const FeatureOptions& options) {
  return extractAs<SparseVector>(image, options);
}

inline std::vector<float> extractDense(const cv::Mat& image, const FeatureOptions& options) {
  return extractAs<DenseVector>(image, options).values;
}

/// Returns a grey image computed from a formula.
inline cv::Mat draw(int width, int height, const std::function<double(int x, int y)>& formula) {
  cv::Mat image(height, width, CV_8UC1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(formula(x, y));
    }
  }
  return image;
}

/// Random pixels below `levels`, the same every time.
inline cv::Mat noise(int width, int height, int type = CV_8UC3, int levels = 256) {
  cv::Mat image(height, width, type);
  cv::RNG(7).fill(image, cv::RNG::UNIFORM, 0, levels);
  return image;
}

}  // namespace place_recognition
