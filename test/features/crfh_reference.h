#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>

#include "place_recognition/feature_options.h"

namespace place_recognition {

/// How many pixels are in each bin of a CRFH with central differences: straight from the
/// definition, pixel by pixel in double precision.
std::map<std::uint64_t, int> referenceCrfh(const cv::Mat& image, const CrfhOptions& options);

}  // namespace place_recognition
