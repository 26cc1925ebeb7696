#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace place_recognition {

/// The grey levels (OpenCV's luma) of a CV_8UC3 or CV_8UC1 image: a grey image itself, so that it
/// is not copied; otherwise `converted`, which must not share memory with an image of the caller.
inline const cv::Mat& greyLevels(const cv::Mat& image, cv::Mat& converted) {
  if (image.channels() == 1) return image;
  cv::cvtColor(image, converted, cv::COLOR_BGR2GRAY);
  return converted;
}

}  // namespace place_recognition
