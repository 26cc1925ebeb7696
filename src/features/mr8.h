#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "features/bin_counter.h"
#include "features/feature_extractor.h"
#include "features/mr8_filter_bank.h"
#include "place_recognition/texture_options.h"

namespace place_recognition {

/// How often the eight maximum responses of the MR8 filter bank occur together in a pixel: a
/// SparseVector of sum 1. The first response is the fastest digit of a bin's index.
///
/// Material categorization with MR8 (Caputo, Hayman and Mallikarjuna 2005) counts textons, cluster
/// centres of such responses, and so needs a dictionary learnt beforehand. The joint histogram is
/// the other representation that Varma and Zisserman (2005) give of the same distribution; it needs
/// none, so that an image alone has its feature, and it suits the same chi-squared kernel.
class Mr8Extractor : public FeatureExtractor {
 public:
  /// Throws Error if the options do not check.
  explicit Mr8Extractor(const Mr8Options& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  void countRow(int y);

  Mr8Options options_;
  Mr8FilterBank filters_;
  Mr8FilterBank::Responses responses_;
  BinCounter counter_;
  std::vector<std::uint64_t> bins_;  ///< of the pixels of one row
  cv::Mat grey_;
  cv::Mat1f image_;
};

}  // namespace place_recognition
