#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace place_recognition {

/// Some real images of rooms, grey, in a fixed order; none where the folder of test data is
/// absent. Takes one file out of `every`.
std::vector<cv::Mat1b> realImages(int every);

/// Smooth random texture with grey levels 0..255: something to detect and describe everywhere.
cv::Mat1f texture(int width, int height, int seed);

}  // namespace place_recognition
