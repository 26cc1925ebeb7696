#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "features/feature_extractor.h"
#include "place_recognition/hog_options.h"

namespace place_recognition {

/// Histograms of oriented gradients (Dalal and Triggs 2005): a DenseVector of rows x columns x
/// orientations values with sum 1, cells row by row. Each pixel that has four neighbours adds the
/// magnitude of its gradient of brightness (central differences), shared linearly between the two
/// nearest orientations; opposite directions are the same. An image without any gradient, or with
/// less than a pixel per cell, has no feature.
class HogExtractor : public FeatureExtractor {
 public:
  /// Throws Error if an option is out of range.
  explicit HogExtractor(const HogOptions& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  /// What a pixel adds to two neighbouring orientations.
  struct Vote {
    std::uint8_t orientations[2];
    float magnitudes[2];
  };

  const cv::Mat& prepare(const cv::Mat& image);
  const Vote& voteFor(int dx, int dy) const;
  void addRow(const cv::Mat& grey, int y);

  HogOptions options_;
  std::vector<Vote> votes_;  ///< by gradient, see voteFor()
  cv::Mat converted_, scaled_;
  std::vector<double> sums_;  ///< rows x columns x orientations
};

}  // namespace place_recognition
