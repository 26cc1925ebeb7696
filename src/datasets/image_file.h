#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace place_recognition {

/// An image, or why there is none.
struct DecodedImage {
  cv::Mat image;        ///< grey or BGR, of 8 or 16 bits per channel; empty if there is a problem
  std::string problem;  ///< for a person, without a full stop
};

/// Decodes an image as cameras send them, PNG, JPEG or WebP, in memory. Only whole images that
/// announce at most 64 million pixels reach the decoder. Never throws for bad bytes. Thread-safe.
DecodedImage decodeImage(const std::uint8_t* bytes, std::size_t size);

/// Whether a file starts as such an image does, whatever its name. False if it cannot be read.
bool startsAsImage(const std::string& path);

/// The same for a file, which may also be BMP, TIFF, PNM (P4 to P6) or JPEG 2000.
DecodedImage readDeepImageFile(const std::string& path);

/// The same, brought to 8 bits by the range of this image alone; for several images see
/// ImageSequence.
DecodedImage readImageFile(const std::string& path);

}  // namespace place_recognition
