#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace place_recognition {

/// An image, or the reason why there is none.
struct DecodedImage {
  cv::Mat image;        ///< grey or BGR, of 8 or 16 bits per channel; empty if there is a problem
  std::string problem;  ///< for a person, without a full stop
};

/// Decodes a camera's image (PNG, JPEG or WebP) in memory. Only complete images that declare at
/// most 64 million pixels reach the decoder. Never throws for bad bytes. Thread-safe.
DecodedImage decodeImage(const std::uint8_t* bytes, std::size_t size);

/// Whether a file begins like such an image, whatever its name. False if it cannot be read.
bool startsAsImage(const std::string& path);

/// Reads an image file in one of these formats, or in BMP, TIFF, PNM (P4 to P6), JPEG 2000 or Sun
/// raster.
DecodedImage readDeepImageFile(const std::string& path);

/// The same, converted to 8 bits with the range of this image alone; for several images see
/// ImageSequence.
DecodedImage readImageFile(const std::string& path);

}  // namespace place_recognition
