#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <variant>

#include "features/feature_extractor.h"

namespace place_recognition {

/// Returns the CRFH of an image and expects that it has one.
inline SparseVector extractCrfh(const CrfhOptions& options, const cv::Mat& image) {
  Feature feature;
  makeFeatureExtractor(options)->extract(image, feature);
  return std::get<SparseVector>(feature);
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

/// Random pixels, the same every time.
inline cv::Mat noise(int width, int height, int type = CV_8UC3) {
  cv::Mat image(height, width, type);
  cv::RNG(7).fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

}  // namespace place_recognition
