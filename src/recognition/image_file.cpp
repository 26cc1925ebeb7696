#include "recognition/image_file.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "base/atomic_file.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::uint64_t kMaxPixels = 64'000'000;
constexpr std::size_t kMaxFileSize = 256'000'000;

/// Width and height as the file announces them; zero if it does not.
struct Size {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
};

std::uint64_t bigEndian(const std::uint8_t* bytes, int width) {
  std::uint64_t value = 0;
  for (int i = 0; i < width; ++i) value = value << 8 | bytes[i];
  return value;
}

/// The signature, then the chunk IHDR with width and height.
Size pngSize(const std::uint8_t* bytes, std::size_t size) {
  static constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  if (size < 24 || !std::equal(std::begin(kSignature), std::end(kSignature), bytes)) return {};
  return {bigEndian(bytes + 16, 4), bigEndian(bytes + 20, 4)};
}

/// Whether every chunk up to the last one, IEND, is there and as its checksum says. Of others
/// libpng would tell on stderr, past the caller.
bool isWholePng(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 8; i + 12 <= size;) {
    const std::uint64_t length = bigEndian(bytes + i, 4);
    if (length > size - i - 12) return false;
    const std::uint8_t* type = bytes + i + 4;
    const auto checksum = crc32(0, type, static_cast<uInt>(length + 4));
    if (checksum != bigEndian(type + 4 + length, 4)) return false;
    if (std::equal(type, type + 4, "IEND")) return true;
    i += length + 12;
  }
  return false;
}

/// Walks the segments of a JPEG file up to the start of frame (SOF), which has height and width.
Size jpegSize(const std::uint8_t* bytes, std::size_t size) {
  if (size < 4 || bytes[0] != 0xff || bytes[1] != 0xd8) return {};
  for (std::size_t i = 2; i + 9 <= size;) {
    if (bytes[i] != 0xff) return {};
    const std::uint8_t marker = bytes[i + 1];
    if (marker == 0xff) {  // A fill byte.
      ++i;
      continue;
    }
    const bool frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) return {bigEndian(bytes + i + 7, 2), bigEndian(bytes + i + 5, 2)};
    // Markers without a length do not stand before it; taking one for a segment would lead to
    // another frame header than the decoder's.
    if (marker < 0xc0 || (marker >= 0xd0 && marker <= 0xd9)) return {};
    i += 2 + bigEndian(bytes + i + 2, 2);
  }
  return {};
}

}  // namespace

DecodedImage decodeImage(const std::uint8_t* bytes, std::size_t size) {
  Size announced = pngSize(bytes, size);
  const bool is_png = announced.width != 0;
  if (!is_png) announced = jpegSize(bytes, size);
  if (announced.width == 0 || announced.height == 0) return {{}, "it is no PNG or JPEG picture"};
  if (announced.width * announced.height > kMaxPixels) {
    return {{},
            "it announces " + std::to_string(announced.width) + " x " +
                std::to_string(announced.height) + " pixels, more than 64 million"};
  }
  if (is_png && !isWholePng(bytes, size)) return {{}, "it is damaged or cut short"};
  if (size > std::numeric_limits<int>::max()) return {{}, "it has more than 2 GB"};
  DecodedImage decoded;
  try {
    const cv::Mat buffer(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(bytes));
    decoded.image = cv::imdecode(buffer, cv::IMREAD_ANYCOLOR);  // 8 bits, grey or BGR
  } catch (const cv::Exception&) {
    decoded.image.release();
  }
  if (decoded.image.empty()) decoded.problem = "it is damaged and cannot be decoded";
  return decoded;
}

DecodedImage readImageFile(const std::string& path) {
  try {
    const std::string bytes = readFile(path, kMaxFileSize);
    return decodeImage(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  } catch (const Error&) {
    return {{}, "it cannot be read or has more than 256 MB"};
  }
}

}  // namespace place_recognition
