#pragma once

#include <opencv2/core.hpp>

#include "features/mr8_filter_bank.h"

namespace place_recognition {

/// Computes the responses of the MR8 filter bank to an image that is converted to grey and
/// normalized to zero mean and unit variance, which makes them independent of brightness and
/// contrast. Keeps its buffers: use one per thread.
class Mr8Responses {
 public:
  /// `weber`: see Mr8Options.
  explicit Mr8Responses(bool weber) : weber_(weber) {}

  /// `image`: CV_8UC3 BGR or CV_8UC1, not empty; valid until the next call.
  const Mr8FilterBank::Responses& of(const cv::Mat& image);

 private:
  void scaleByContrast();

  bool weber_;
  Mr8FilterBank filters_;
  Mr8FilterBank::Responses responses_;
  cv::Mat converted_;
  cv::Mat1f normalized_;
};

}  // namespace place_recognition
