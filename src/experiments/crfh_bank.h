#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/bin_counter.h"
#include "features/crfh_descriptor.h"
#include "features/crfh_responses.h"
#include "features/row_kernels.h"
#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Many composed receptive field histograms of one image, identical to those of CrfhExtractor. Each
/// response is computed once, and quantized once per number of bins, for all histograms that use
/// it. Use one bank per thread.
class CrfhBank {
 public:
  /// `histograms`: at least one; all must agree in derivatives, derivative_range, half_width and
  /// border.
  explicit CrfhBank(const std::vector<CrfhOptions>& histograms);

  /// `image`: CV_8UC3 BGR or CV_8UC1. The features are missing if it is too small.
  std::vector<Feature> extract(const cv::Mat& image);

 private:
  /// Digits of one descriptor at one scale, for every counted pixel.
  struct Digits {
    CrfhResponses::Response response;
    int bins;
    Quantizer quantizer;
    std::vector<std::uint32_t> pixels;
  };
  struct Dimension {
    std::size_t digits;
    std::uint64_t weight;
  };

  std::size_t digitsOf(const CrfhDescriptor& descriptor, double t, int bins,
                       const CrfhOptions& options);
  void quantizeAll(const cv::Mat& image, int columns, int rows);
  void count(const std::vector<Dimension>& histogram, std::size_t pixels, Feature& feature);

  CrfhResponses responses_;
  int border_ = 0;
  std::vector<Digits> digits_;
  std::vector<std::vector<Dimension>> histograms_;
  std::vector<std::uint32_t> row_;
  std::vector<std::uint64_t> bins_;
  BinCounter counter_;
};

}  // namespace place_recognition
