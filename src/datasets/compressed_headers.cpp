// The compressed formats: PNG, JPEG, JPEG 2000 and WebP.
#include <zlib.h>

#include <algorithm>
#include <string_view>

#include "datasets/format_headers.h"

namespace place_recognition {
namespace {

using namespace std::literals;

/// Whether every chunk up to the last one, IEND, is present and matches its checksum. libpng would
/// report other files on stderr, bypassing the caller.
bool isWholePng(const FileBytes& file) {
  for (std::uint64_t i = 8; i + 12 <= file.size();) {
    const std::uint64_t length = file.big(i, 4);
    if (length > file.size() - i - 12) return false;
    const auto checksum = crc32(0, file.data(i + 4), static_cast<uInt>(length + 4));
    if (checksum != file.big(i + 8 + length, 4)) return false;
    if (file.startsWith("IEND", i + 4)) return true;
    i += length + 12;
  }
  return false;
}

/// Whether the first `size` bytes end in an unfilled buffer: more than a quarter are zeros,
/// compared with a twentieth in images of a single colour.
bool endsInZeros(const FileBytes& file, std::uint64_t size) {
  std::uint64_t end = size;
  while (end > 0 && file.at(end - 1) == 0) --end;
  return size - end > size / 4;
}

}  // namespace

/// A signature, then chunks: length, type, data, checksum; the first has width and height.
ImageHeader readPngHeader(const FileBytes& file) {
  return {ImageFormat::kPng, file.big(16, 4), file.big(20, 4), isWholePng(file)};
}

/// Walks the segments of a JPEG file up to the start of frame (SOF), which has height and width.
ImageHeader readJpegHeader(const FileBytes& file) {
  ImageHeader header{ImageFormat::kJpeg, 0, 0, true};
  for (std::uint64_t i = 2; i + 9 <= file.size();) {
    if (file.at(i) != 0xff) break;
    const std::uint8_t marker = file.at(i + 1);
    if (marker == 0xff) {  // A fill byte.
      ++i;
      continue;
    }
    const bool frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) {
      header.width = file.big(i + 7, 2);
      header.height = file.big(i + 5, 2);
      break;
    }
    // Markers without a length do not occur before it; treating one as a segment would lead to
    // another frame header than the decoder's.
    if (marker < 0xc0 || (marker >= 0xd0 && marker <= 0xd9)) break;
    i += 2 + file.big(i + 2, 2);
  }
  return header;
}

/// A bare codestream, or one in boxes: length, type, data. The codestream begins with SOC and SIZ,
/// which contains the corners of the image, and ends with EOC.
ImageHeader readJpeg2000Header(const FileBytes& file) {
  ImageHeader header{ImageFormat::kJpeg2000, 0, 0, false};
  std::uint64_t start = 0, end = file.size();
  if (!file.startsWith("\xff\x4f\xff\x51"sv)) {
    while (start + 8 <= file.size() && !file.startsWith("jp2c", start + 4)) {
      const std::uint64_t length = file.big(start, 4);
      if (length < 8) return header;  // the last box, or one of more than 4 GB
      start += length;
    }
    const std::uint64_t length = file.big(start, 4);
    if (length != 0) end = start + length;
    start += 8;
  }
  constexpr std::uint64_t kMaxComponents = 4;
  if (!file.startsWith("\xff\x4f\xff\x51"sv, start) || file.big(start + 40, 2) > kMaxComponents) {
    return header;
  }
  header.width = file.big(start + 8, 4) - std::min(file.big(start + 16, 4), file.big(start + 8, 4));
  header.height =
      file.big(start + 12, 4) - std::min(file.big(start + 20, 4), file.big(start + 12, 4));
  header.whole = end <= file.size() && end >= 2 && file.startsWith("\xff\xd9"sv, end - 2);
  return header;
}

/// RIFF, its length, WEBP, then a chunk of one of three kinds.
ImageHeader readWebpHeader(const FileBytes& file) {
  const std::uint64_t size = file.little(4, 4) + 8;
  ImageHeader header{ImageFormat::kWebp, 0, 0, size <= file.size() && !endsInZeros(file, size)};
  if (file.startsWith("VP8 ", 12)) {
    header.width = file.little(26, 2) & 0x3fff;
    header.height = file.little(28, 2) & 0x3fff;
  } else if (file.startsWith("VP8L", 12)) {
    const std::uint64_t bits = file.little(21, 4);
    header.width = (bits & 0x3fff) + 1;
    header.height = (bits >> 14 & 0x3fff) + 1;
  } else if (file.startsWith("VP8X", 12)) {
    header.width = file.little(24, 3) + 1;
    header.height = file.little(27, 3) + 1;
  }
  return header;
}

}  // namespace place_recognition
