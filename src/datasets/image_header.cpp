#include "datasets/image_header.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>

namespace place_recognition {
namespace {

/// The bytes of a file; what lies beyond its end reads as zero.
class Bytes {
 public:
  Bytes(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), size_(size) {}

  std::uint64_t size() const { return size_; }
  std::uint8_t at(std::uint64_t i) const { return i < size_ ? bytes_[i] : 0; }
  const std::uint8_t* data(std::uint64_t i) const { return bytes_ + i; }

  bool startsWith(std::string_view text, std::uint64_t offset = 0) const {
    return offset + text.size() <= size_ &&
           std::equal(text.begin(), text.end(), bytes_ + offset,
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  }

  std::uint64_t big(std::uint64_t i, int width) const {
    std::uint64_t value = 0;
    for (int k = 0; k < width; ++k) value = value << 8 | at(i + static_cast<std::uint64_t>(k));
    return value;
  }

  std::uint64_t little(std::uint64_t i, int width) const {
    std::uint64_t value = 0;
    for (int k = width; k-- > 0;) value = value << 8 | at(i + static_cast<std::uint64_t>(k));
    return value;
  }

 private:
  const std::uint8_t* bytes_;
  std::uint64_t size_;
};

using namespace std::literals;

// PNG: a signature, then chunks: length, type, data, checksum; the first has width and height.

/// Whether every chunk up to the last one, IEND, is there and as its checksum says. Of others
/// libpng would tell on stderr, past the caller.
bool isWholePng(const Bytes& file) {
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

ImageHeader readPng(const Bytes& file) {
  return {ImageFormat::kPng, file.big(16, 4), file.big(20, 4), isWholePng(file)};
}

/// Walks the segments of a JPEG file up to the start of frame (SOF), which has height and width.
ImageHeader readJpeg(const Bytes& file) {
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
    // Markers without a length do not stand before it; taking one for a segment would lead to
    // another frame header than the decoder's.
    if (marker < 0xc0 || (marker >= 0xd0 && marker <= 0xd9)) break;
    i += 2 + file.big(i + 2, 2);
  }
  return header;
}

/// Whether the first `size` bytes end in a buffer that was not filled: more than a quarter are
/// zeros, where images of one colour have a twentieth.
bool endsInZeros(const Bytes& file, std::uint64_t size) {
  std::uint64_t end = size;
  while (end > 0 && file.at(end - 1) == 0) --end;
  return size - end > size / 4;
}

/// RIFF, its length, WEBP, then a chunk of one of three kinds.
ImageHeader readWebp(const Bytes& file) {
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

ImageHeader readBmp(const Bytes& file) {
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
    // Negative where the upper row comes first.
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

/// The first directory of a TIFF file, in its byte order.
class TiffDirectory {
 public:
  explicit TiffDirectory(const Bytes& file)
      : file_(file), big_(file.startsWith("MM")), start_(read(4, 4)), count_(read(start_, 2)) {}

  /// The only number of the entry `tag`; zero if it has none.
  std::uint64_t value(std::uint64_t tag) const {
    const Entry entry = find(tag);
    return entry.count == 0 ? 0 : number(entry, 0);
  }

  /// Whether the parts at `offsets`, of lengths `lengths`, lie in the file.
  bool hasParts(std::uint64_t offsets, std::uint64_t lengths) const {
    const Entry starts = find(offsets), sizes = find(lengths);
    if (starts.count == 0 || starts.count != sizes.count || starts.count > file_.size()) {
      return false;
    }
    for (std::uint64_t i = 0; i < starts.count; ++i) {
      if (number(starts, i) + number(sizes, i) > file_.size()) return false;
    }
    return true;
  }

 private:
  /// `count` numbers of `width` bytes, the first one at `first`.
  struct Entry {
    int width = 0;
    std::uint64_t count = 0;
    std::uint64_t first = 0;
  };

  Entry find(std::uint64_t tag) const {
    for (std::uint64_t k = 0; k < count_; ++k) {
      const std::uint64_t at = start_ + 2 + 12 * k;
      if (read(at, 2) != tag) continue;
      const int width = read(at + 2, 2) == 3 ? 2 : 4;  // SHORT, else LONG
      const std::uint64_t count = read(at + 4, 4);
      const bool within = count * static_cast<std::uint64_t>(width) <= 4;
      return {width, count, within ? at + 8 : read(at + 8, 4)};
    }
    return {};
  }

  std::uint64_t number(const Entry& entry, std::uint64_t i) const {
    return read(entry.first + i * static_cast<std::uint64_t>(entry.width), entry.width);
  }

  std::uint64_t read(std::uint64_t i, int width) const {
    return big_ ? file_.big(i, width) : file_.little(i, width);
  }

  const Bytes& file_;
  bool big_;
  std::uint64_t start_;
  std::uint64_t count_;
};

ImageHeader readTiff(const Bytes& file) {
  constexpr std::uint64_t kWidth = 256, kHeight = 257, kStrips = 273, kStripBytes = 279;
  constexpr std::uint64_t kTileWidth = 322, kTileHeight = 323, kTiles = 324, kTileBytes = 325;
  const TiffDirectory directory(file);
  return {ImageFormat::kTiff, std::max(directory.value(kWidth), directory.value(kTileWidth)),
          std::max(directory.value(kHeight), directory.value(kTileHeight)),
          directory.hasParts(kStrips, kStripBytes) || directory.hasParts(kTiles, kTileBytes)};
}

/// How many numbers stand from `i` on; digits of bitmaps need not be separated.
std::uint64_t countNumbers(const Bytes& file, std::uint64_t i, bool each_digit) {
  std::uint64_t count = 0;
  for (bool within = false; i < file.size(); ++i) {
    const bool digit = std::isdigit(file.at(i)) != 0;
    if (digit && (each_digit || !within)) ++count;
    within = digit;
  }
  return count;
}

/// The netpbm formats in text, P1 to P3, and in bytes, P4 to P6: numbers as text, with comments,
/// then pixels.
ImageHeader readPnm(const Bytes& file) {
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
  // Both below 10^9, so the product fits.
  return {ImageFormat::kPnm, width, height, i + 1 + row * height <= file.size()};
}

/// A bare codestream, or one in boxes: length, type, data. It starts with SOC and SIZ, which has
/// the corners of the image, and ends with EOC.
ImageHeader readJpeg2000(const Bytes& file) {
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

/// Eight numbers, then colours and rows of pixels; a length of the pixels is given if they are
/// compressed.
ImageHeader readSunRaster(const Bytes& file) {
  const std::uint64_t width = file.big(4, 4), height = file.big(8, 4), bits = file.big(12, 4);
  const std::uint64_t row = (width * bits + 15) / 16 * 2;
  const bool compressed = file.big(20, 4) == 2;
  const std::uint64_t pixels = compressed ? file.big(16, 4) : row * height;
  // All below 2^32, and `row` below 2^62 with a sound number of bits.
  const bool sound = bits <= 32 && width <= 1 << 16 && height <= 1 << 16;
  return {ImageFormat::kSunRaster, width, height,
          sound && 32 + file.big(28, 4) + pixels <= file.size()};
}

struct Signature {
  std::string_view start;
  ImageHeader (*read)(const Bytes&);
};

constexpr std::array<Signature, 15> kSignatures{{
    {"\x89PNG\r\n\x1a\n"sv, readPng},
    {"\xff\xd8"sv, readJpeg},
    {"RIFF"sv, readWebp},
    {"BM"sv, readBmp},
    {"II*\0"sv, readTiff},
    {"MM\0*"sv, readTiff},
    {"P1"sv, readPnm},
    {"P2"sv, readPnm},
    {"P3"sv, readPnm},
    {"P4"sv, readPnm},
    {"P5"sv, readPnm},
    {"P6"sv, readPnm},
    {"\x59\xa6\x6a\x95"sv, readSunRaster},
    {"\xff\x4f\xff\x51"sv, readJpeg2000},
    {"\0\0\0\x0cjP  \r\n\x87\n"sv, readJpeg2000},
}};

}  // namespace

ImageHeader readImageHeader(const std::uint8_t* bytes, std::size_t size) {
  const Bytes file(bytes, size);
  const auto found =
      std::find_if(kSignatures.begin(), kSignatures.end(),
                   [&file](const Signature& kind) { return file.startsWith(kind.start); });
  if (found == kSignatures.end()) return {};
  if (found->read == readWebp && !file.startsWith("WEBP", 8)) return {};
  return found->read(file);
}

}  // namespace place_recognition
