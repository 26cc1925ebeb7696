#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace place_recognition {

/// The least work for CRFH responses: for each of them, an image of floats is copied and passed
/// over once with a fused multiply-add for every tap of the two filters, along the rows and along
/// the columns. Plain loops that the compiler vectorises; all weights are the same, so that they
/// take but one register.
class CrfhLimit {
 public:
  /// `variances`: the scale t of each response.
  explicit CrfhLimit(const std::vector<double>& variances);

  void compute(cv::Size size);

 private:
  std::vector<int> taps_;  ///< of each response
  /// One above the other: of two pieces of memory that stand 64 or 128 bytes apart, modulo 4096,
  /// the processor takes what is written to one for what it reads of the other, half as long again.
  cv::Mat_<float> images_;
};

}  // namespace place_recognition
