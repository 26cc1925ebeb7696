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

/// How often the eight maximum responses of the MR8 filter bank occur together in a pixel: a
/// SparseVector of sum 1. The first response is the fastest digit of a bin's index.
///
/// The thesis counts textons, cluster centres of such responses, and so needs a dictionary learned
/// beforehand (experiments/textons.h). The joint histogram is the other representation that Varma
/// and Zisserman (2005) give of the same distribution; it needs none, so that an image alone has
/// its feature, and it suits the same chi-squared kernel.
class Mr8Extractor : public FeatureExtractor {
 public:
  /// Throws Error if the options do not check.
  explicit Mr8Extractor(const Mr8Options& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  void countRow(const Mr8FilterBank::Responses& responses, int y);

  Mr8Options options_;
  std::array<Quantizer, Mr8FilterBank::kResponses> quantizers_;
  Mr8Responses responses_;
  BinCounter counter_;
  std::vector<std::uint32_t> word_;  ///< of the pixels of one row, half of the digits of their bins
  std::vector<std::uint64_t> bins_;
};

}  // namespace place_recognition
