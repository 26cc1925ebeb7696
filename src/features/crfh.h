#pragma once

#include <cstdint>
#include <vector>

#include "features/bin_counter.h"
#include "features/crfh_responses.h"
#include "features/feature_extractor.h"
#include "features/row_kernels.h"

namespace place_recognition {

/// Composed receptive field histograms, thesis section 4.2: the joint frequencies of the responses
/// of several descriptors at a pixel. The feature is a SparseVector that sums to 1.
///
/// A bin's index is a mixed-radix number, first digit fastest (eq. 4.24). Its digits are the
/// quantized responses of the first descriptor at the first scale, the second descriptor at the
/// first scale, and so on; then those at the second scale.
class CrfhExtractor : public FeatureExtractor {
 public:
  explicit CrfhExtractor(const CrfhOptions& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  struct Dimension {
    CrfhResponses::Response response;
    std::size_t word;
    bool first_in_word;
    Quantizer quantizer;
  };
  /// Consecutive digits that together fit 32 bits, in which they are accumulated.
  struct Word {
    std::uint64_t weight;
    std::vector<std::uint32_t> row;
  };

  /// `image` with the levels to count: itself, or a copy in `levels_`.
  const cv::Mat& inLevels(const cv::Mat& image);
  void countRow(int r, int columns);

  bool logarithmic_;
  cv::Mat levels_;
  CrfhResponses responses_;
  int border_ = 0;  ///< Pixels at each side of the image that are not counted.
  std::vector<Dimension> dimensions_;
  std::vector<Word> words_;
  std::vector<std::uint64_t> bins_;  ///< Of the pixels of one row.
  BinCounter counter_;
};

}  // namespace place_recognition
