#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/bin_counter.h"
#include "features/crfh_descriptor.h"
#include "features/response_filter.h"
#include "features/row_kernels.h"
#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Many composed receptive field histograms of one picture, the same as CrfhExtractor's: each
/// response is computed once and quantised once for each number of bins, however many histograms
/// use it. One bank a thread.
class CrfhBank {
 public:
  /// The histograms must agree in derivatives, derivative_range, half_width and border.
  explicit CrfhBank(const std::vector<CrfhOptions>& histograms);

  /// `image`: CV_8UC3 BGR or CV_8UC1. Missing features if it is too small.
  std::vector<Feature> extract(const cv::Mat& image);

 private:
  struct Plane {
    Channel channel;
    cv::Mat_<float> pixels;
  };
  struct Filter {
    std::size_t plane;
    double t;
    ResponseFilter responses;
  };
  /// Digits of one descriptor at one scale in every counted pixel.
  struct Digits {
    std::size_t filter;
    Operator op;
    int bins;
    Quantizer quantizer;
    std::vector<std::uint32_t> pixels;
  };
  struct Dimension {
    std::size_t digits;
    std::uint64_t weight;
  };

  std::size_t planeOf(Channel channel);
  std::size_t filterOf(Channel channel, double t, const CrfhOptions& options);
  std::size_t digitsOf(const CrfhDescriptor& descriptor, double t, int bins,
                       const CrfhOptions& options);
  void quantise(const cv::Mat& image, int columns, int rows);
  void count(const std::vector<Dimension>& histogram, std::size_t pixels, Feature& feature);

  int border_ = 0;
  std::vector<Plane> planes_;
  std::vector<Filter> filters_;
  std::vector<Digits> digits_;
  std::vector<std::vector<Dimension>> histograms_;
  std::vector<std::uint64_t> bins_;
  BinCounter counter_;
};

}  // namespace place_recognition
