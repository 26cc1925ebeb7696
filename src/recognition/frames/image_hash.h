#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "place_recognition/recording.h"
#include "place_recognition/run_sketch.h"

namespace place_recognition {

/// 64 bits of the SHA-256 of the size, the type and some rows of an image (CV_8UC3, CV_8UC1 or
/// empty), which are the same in every copy of it. An image without pixels or of a single colour
/// has none: a covered lens looks alike in every run.
std::optional<std::uint64_t> imageHash(const cv::Mat& image);

/// Adds a frame that can be learned, that is, one with a label and the hash of an image.
void addLabelled(const Frame& frame, RunSketch& sketch);

}  // namespace place_recognition
