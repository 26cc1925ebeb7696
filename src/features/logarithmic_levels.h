#pragma once

#include <opencv2/core/mat.hpp>

namespace place_recognition {

/// The levels v of `image` (CV_8U) as log(1 + v / 16), scaled to 0..255. The 16 keeps the noise of
/// dark pixels small.
void takeLogarithms(const cv::Mat& image, cv::Mat& levels);

}  // namespace place_recognition
