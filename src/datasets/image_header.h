#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

enum class ImageFormat { kNone, kPng, kJpeg, kWebp, kBmp, kTiff, kPnm, kJpeg2000, kSunRaster };

/// The properties that an image declares, read before decoding.
struct ImageHeader {
  ImageFormat format = ImageFormat::kNone;
  std::uint64_t width = 0;   ///< pixels; for TIFF at least a tile's width
  std::uint64_t height = 0;  ///< likewise
  bool whole = false;  ///< nothing is missing as far as lengths and checksums show; for JPEG see
                       ///< isWholeJpeg()
};

/// Reads the header of an image. The format is kNone if it is unknown, and the width is 0 if the
/// size cannot be determined. Never throws. Thread-safe.
ImageHeader readImageHeader(const std::uint8_t* bytes, std::size_t size);

}  // namespace place_recognition
