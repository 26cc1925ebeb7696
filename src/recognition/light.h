#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace place_recognition {

/// A change of light, as a gain of each channel: the camera's exposure and white balance do not
/// follow the sun and the lamps.
struct Light {
  double red = 1;
  double green = 1;
  double blue = 1;
};

/// Darker, brighter, warmer and colder, by about as much as automatic exposure and white balance
/// leave over.
const std::vector<Light>& otherLights();

/// `image` (CV_8UC3 BGR or CV_8UC1 grey) in that light, saturated at white.
cv::Mat inLight(const cv::Mat& image, const Light& light);

/// The same into `changed`, whose memory is reused.
void changeLight(const cv::Mat& image, const Light& light, cv::Mat& changed);

}  // namespace place_recognition
