#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

enum class ImageFormat { kNone, kPng, kJpeg, kWebp, kBmp, kTiff, kPnm, kJpeg2000, kSunRaster };

/// What an image says of itself before anything of it is decoded.
struct ImageHeader {
  ImageFormat format = ImageFormat::kNone;
  std::uint64_t width = 0;   ///< pixels; of TIFF not less than a tile's
  std::uint64_t height = 0;  ///< likewise
  bool whole = false;  ///< as far as lengths and checksums tell, nothing is missing; of JPEG see
                       ///< isWholeJpeg()
};

/// Reads the header of an image; format kNone if it is of none that is known, width 0 if its size
/// cannot be told. Never throws. Thread-safe.
ImageHeader readImageHeader(const std::uint8_t* bytes, std::size_t size);

}  // namespace place_recognition
