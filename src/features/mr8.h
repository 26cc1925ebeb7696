#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "features/bin_counter.h"
#include "features/feature_extractor.h"
#include "features/mr8_responses.h"
#include "features/row_kernels.h"
#include "place_recognition/texture_options.h"

namespace place_recognition {

/// Extracts the joint histogram of the eight maximum responses of the MR8 filter bank: a
/// SparseVector of sum 1. The first response is the fastest-varying digit of a bin's index.
///
/// The thesis counts textons, that is, cluster centres of such responses, which requires a learned
/// dictionary (experiments/textons.h). The joint histogram is the alternative representation of
/// Varma and Zisserman (2005). It needs no dictionary and suits the same chi-squared kernel.
class Mr8Extractor : public FeatureExtractor {
 public:
  /// Throws Error if an option is out of range.
  explicit Mr8Extractor(const Mr8Options& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  void countRow(const Mr8FilterBank::Responses& responses, int y);

  Mr8Options options_;
  std::array<Quantizer, Mr8FilterBank::kResponses> quantizers_;
  Mr8Responses responses_;
  BinCounter counter_;
  std::vector<std::uint32_t> word_;  ///< for each pixel of a row, half of the digits of its bin
  std::vector<std::uint64_t> bins_;
};

}  // namespace place_recognition
