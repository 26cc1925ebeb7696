#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace place_recognition {

/// A picture, or why there is none.
struct DecodedImage {
  cv::Mat image;        ///< CV_8UC3 BGR or CV_8UC1; empty if there is a problem
  std::string problem;  ///< for a person, without a full stop
};

/// Decodes a PNG or JPEG picture in memory; nothing else, and nothing that announces more than 64
/// million pixels, reaches the decoder. Never throws for bad bytes. Thread-safe.
DecodedImage decodeImage(const std::uint8_t* bytes, std::size_t size);

/// The same for a file.
DecodedImage readImageFile(const std::string& path);

}  // namespace place_recognition
