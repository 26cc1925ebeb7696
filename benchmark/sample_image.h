#pragma once

#include <opencv2/core/mat.hpp>

namespace place_recognition {

/// Returns a BGR image of 640 x 480: number `number` of the real ones below the folder
/// $PLACE_RECOGNITION_TEST_DATA or, if there are not as many, noise at all scales, which fills as
/// many bins of a histogram.
cv::Mat sampleImage(std::size_t number);

}  // namespace place_recognition
