#include <algorithm>

#include "datasets/format_headers.h"

namespace place_recognition {
namespace {

/// The first directory of a TIFF file, in its byte order.
class TiffDirectory {
 public:
  explicit TiffDirectory(const FileBytes& file)
      : file_(file), big_(file.startsWith("MM")), start_(read(4, 4)), count_(read(start_, 2)) {}

  /// The only number of the entry `tag`; zero if it has none.
  std::uint64_t value(std::uint64_t tag) const {
    const Entry entry = find(tag);
    return entry.count == 0 ? 0 : number(entry, 0);
  }

  /// Whether the file contains the parts at `offsets` with the lengths `lengths`.
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
  /// `count` numbers of `width` bytes each, the first one at `first`.
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

  const FileBytes& file_;
  bool big_;
  std::uint64_t start_;
  std::uint64_t count_;
};

}  // namespace

ImageHeader readTiffHeader(const FileBytes& file) {
  constexpr std::uint64_t kWidth = 256, kHeight = 257, kStrips = 273, kStripBytes = 279;
  constexpr std::uint64_t kTileWidth = 322, kTileHeight = 323, kTiles = 324, kTileBytes = 325;
  const TiffDirectory directory(file);
  return {ImageFormat::kTiff, std::max(directory.value(kWidth), directory.value(kTileWidth)),
          std::max(directory.value(kHeight), directory.value(kTileHeight)),
          directory.hasParts(kStrips, kStripBytes) || directory.hasParts(kTiles, kTileBytes)};
}

}  // namespace place_recognition
