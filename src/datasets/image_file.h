#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace place_recognition {

/// A picture, or why there is none.
struct DecodedImage {
  cv::Mat image;        ///< grey or BGR, of 8 or 16 bits a channel; empty if there is a problem
  std::string problem;  ///< for a person, without a full stop
};

/// Decodes a picture as cameras send them, PNG, JPEG or WebP, in memory. Only whole pictures that
/// announce at most 64 million pixels reach the decoder. Never throws for bad bytes. Thread-safe.
DecodedImage decodeImage(const std::uint8_t* bytes, std::size_t size);

/// Whether a file starts as such a picture does, whatever its name. False if it cannot be read.
bool startsAsPicture(const std::string& path);

/// The same for a file, which may also be BMP, TIFF, PNM (P4 to P6) or JPEG 2000.
DecodedImage readDeepImageFile(const std::string& path);

/// The same, brought to 8 bits by the range of this picture alone; for several pictures see
/// PictureSequence.
DecodedImage readImageFile(const std::string& path);

}  // namespace place_recognition
