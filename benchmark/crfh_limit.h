#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace place_recognition {

/// The least work for CRFH responses. For each response, a float image is copied and filtered once,
/// along the rows and along the columns, with one fused multiply-add per tap. The loops are plain
/// and vectorized by the compiler. All weights are equal, so that they need only one register.
class CrfhLimit {
 public:
  /// `variances`: the scale t of each response.
  explicit CrfhLimit(const std::vector<double>& variances);

  void compute(cv::Size size);

 private:
  std::vector<int> taps_;  ///< per response
  /// One above the other. If two buffers are 64 or 128 bytes apart, modulo 4096, the processor
  /// takes writes to one for reads of the other (4K aliasing) and needs half as long again.
  cv::Mat_<float> images_;
};

}  // namespace place_recognition
