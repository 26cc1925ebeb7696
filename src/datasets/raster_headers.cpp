// The formats that store rows of pixels: BMP, PNM and Sun raster.
#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "datasets/format_headers.h"

namespace place_recognition {
namespace {

/// Number of numbers from `i` on; the digits of bitmaps need not be separated.
std::uint64_t countNumbers(const FileBytes& file, std::uint64_t i, bool each_digit) {
  std::uint64_t count = 0;
  for (bool within = false; i < file.size(); ++i) {
    const bool digit = std::isdigit(file.at(i)) != 0;
    if (digit && (each_digit || !within)) ++count;
    within = digit;
  }
  return count;
}

}  // namespace

ImageHeader readBmpHeader(const FileBytes& file) {
  ImageHeader header{ImageFormat::kBmp, 0, 0, false};
  const std::uint64_t pixels = file.little(10, 4);
  std::uint64_t bits, compression = 0;
  if (file.little(14, 4) == 12) {  // OS/2
    header.width = file.little(18, 2);
    header.height = file.little(20, 2);
    bits = file.little(24, 2);
  } else {
    const auto signedAt = [&file](std::uint64_t i) {
      return static_cast<std::int32_t>(file.little(i, 4));
    };
    header.width = static_cast<std::uint64_t>(std::max(signedAt(18), 0));
    // Negative if the upper row comes first.
    header.height = static_cast<std::uint64_t>(std::llabs(signedAt(22)));
    bits = file.little(28, 2);
    compression = file.little(30, 4);
  }
  const bool run_lengths = compression == 1 || compression == 2;
  const std::uint64_t row = (header.width * bits + 31) / 32 * 4;
  header.whole =
      run_lengths ? file.little(2, 4) <= file.size() : pixels + row * header.height <= file.size();
  return header;
}

/// The netpbm formats as text, P1 to P3, and as bytes, P4 to P6: numbers as text, with comments,
/// then pixels.
ImageHeader readPnmHeader(const FileBytes& file) {
  std::uint64_t i = 2;
  const auto number = [&file, &i] {
    for (; std::isspace(file.at(i)) || file.at(i) == '#'; ++i) {
      while (file.at(i) == '#' && i < file.size()) {
        while (i < file.size() && file.at(i) != '\n') ++i;
      }
    }
    std::uint64_t value = 0;
    for (; std::isdigit(file.at(i)) && value < 100'000'000; ++i) {
      value = value * 10 + static_cast<std::uint64_t>(file.at(i) - '0');
    }
    return value;
  };
  const char kind = static_cast<char>(file.at(1));
  const std::uint64_t width = number(), height = number();
  const bool bitmap = kind == '1' || kind == '4';
  const std::uint64_t largest = bitmap ? 1 : number();
  if (kind <= '3') {
    const std::uint64_t needed = width * height * (kind == '3' ? 3 : 1);
    return {ImageFormat::kPnm, width, height, countNumbers(file, i, bitmap) >= needed};
  }
  const std::uint64_t row =
      bitmap ? (width + 7) / 8 : width * (kind == '6' ? 3 : 1) * (largest > 255 ? 2 : 1);
  // Both are below 10^9, so the product fits.
  return {ImageFormat::kPnm, width, height, i + 1 + row * height <= file.size()};
}

/// Eight numbers, then colours and rows of pixels; the length of the pixels is given if they are
/// compressed.
ImageHeader readSunRasterHeader(const FileBytes& file) {
  const std::uint64_t width = file.big(4, 4), height = file.big(8, 4), bits = file.big(12, 4);
  const std::uint64_t row = (width * bits + 15) / 16 * 2;
  const bool compressed = file.big(20, 4) == 2;
  const std::uint64_t pixels = compressed ? file.big(16, 4) : row * height;
  // All are below 2^32, and `row` is below 2^62 if the number of bits is valid.
  const bool sound = bits <= 32 && width <= 1 << 16 && height <= 1 << 16;
  return {ImageFormat::kSunRaster, width, height,
          sound && 32 + file.big(28, 4) + pixels <= file.size()};
}

}  // namespace place_recognition
