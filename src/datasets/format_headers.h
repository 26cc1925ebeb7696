#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "datasets/image_header.h"

namespace place_recognition {

/// The bytes of a file; positions beyond its end read as zero.
class FileBytes {
 public:
  FileBytes(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), size_(size) {}

  std::uint64_t size() const { return size_; }
  std::uint8_t at(std::uint64_t i) const { return i < size_ ? bytes_[i] : 0; }
  const std::uint8_t* data(std::uint64_t i) const { return bytes_ + i; }

  bool startsWith(std::string_view text, std::uint64_t offset = 0) const {
    return offset + text.size() <= size_ &&
           std::equal(text.begin(), text.end(), bytes_ + offset,
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  }

  /// The big-endian number of `width` bytes at `i`.
  std::uint64_t big(std::uint64_t i, int width) const {
    std::uint64_t value = 0;
    for (int k = 0; k < width; ++k) value = value << 8 | at(i + static_cast<std::uint64_t>(k));
    return value;
  }

  /// The little-endian one.
  std::uint64_t little(std::uint64_t i, int width) const {
    std::uint64_t value = 0;
    for (int k = width; k-- > 0;) value = value << 8 | at(i + static_cast<std::uint64_t>(k));
    return value;
  }

 private:
  const std::uint8_t* bytes_;
  std::uint64_t size_;
};

// One reader per format, for files that begin with its signature.

ImageHeader readPngHeader(const FileBytes& file);
ImageHeader readJpegHeader(const FileBytes& file);
ImageHeader readJpeg2000Header(const FileBytes& file);
ImageHeader readWebpHeader(const FileBytes& file);
ImageHeader readTiffHeader(const FileBytes& file);
ImageHeader readBmpHeader(const FileBytes& file);
ImageHeader readPnmHeader(const FileBytes& file);
ImageHeader readSunRasterHeader(const FileBytes& file);

}  // namespace place_recognition
