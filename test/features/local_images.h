#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace place_recognition {

/// Returns every n-th of the real images of rooms, with n = `every`, grey, in a fixed order; none
/// if the folder of test data is absent.
std::vector<cv::Mat1b> realImages(int every);

/// Smooth random texture with grey levels 0..255: something to detect and describe everywhere.
cv::Mat1f texture(int width, int height, int seed);

}  // namespace place_recognition
