#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>

#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Counts the pixels in each bin of a CRFH with central differences, by the definition: pixel by
/// pixel in double precision.
std::map<std::uint64_t, int> referenceCrfh(const cv::Mat& image, const CrfhOptions& options);

}  // namespace place_recognition
