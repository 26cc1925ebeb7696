#pragma once

#include <opencv2/core/mat.hpp>

namespace place_recognition {

/// Measures the information in an image: the fraction of its pixels, 0..1, whose gradient at sigma
/// = 1 exceeds 4 grey levels per pixel. A bare wall that fills the view has almost none. Keeps its
/// buffers: use one per thread.
class EdgeDensity {
 public:
  /// `image`: CV_8UC3 BGR or CV_8UC1, not empty.
  double of(const cv::Mat& image);

 private:
  cv::Mat converted_, smoothed_, x_, y_;
};

}  // namespace place_recognition
