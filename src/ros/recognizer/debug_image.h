#pragma once

#include <opencv2/core/mat.hpp>

#include "place_recognition/model.h"
#include "place_recognition/recognizer.h"

namespace place_recognition {

/// The image (CV_8UC3 or CV_8UC1) with the answer in its upper left corner and, below it, one bar
/// per place for its probability; CV_8UC3.
cv::Mat drawAnswer(const cv::Mat& image, const Recognition& recognition, const Model& model);

}  // namespace place_recognition
