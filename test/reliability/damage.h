#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace place_recognition {

/// Damaged files, as left by disks, transfers and attackers: bytes are changed, cut, repeated,
/// lost, or spliced in from other files of the same kind. The same seed gives the same files.
class Damage {
 public:
  Damage(std::vector<std::string> originals, unsigned seed)
      : originals_(std::move(originals)), random_(seed) {}

  /// Returns a copy of one of the originals with one to eight faults.
  std::string next() {
    std::string bytes = any();
    for (std::size_t i = 0, count = std::size_t{1} << below(4); i < count; ++i) damage(bytes);
    return bytes;
  }

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

 private:
  const std::string& any() { return originals_[below(originals_.size())]; }

  void damage(std::string& bytes) {
    const std::size_t at = below(bytes.size()), length = std::min(below(64), bytes.size() - at);
    switch (below(7)) {
      case 0:
        if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes.replace(at, length, length, "\x00\x01\x7f\x80\xff"[below(5)]);
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 5: {  // an empty field or a length, many times
        const std::string twice{static_cast<char>(random_()), static_cast<char>(below(3))};
        for (std::size_t i = below(200); i > 0; --i) bytes.insert(at, twice);
        break;
      }
      default: {
        const std::string& other = any();
        bytes.replace(at, length, other, below(other.size()), below(200));
      }
    }
  }

  std::vector<std::string> originals_;
  std::mt19937 random_;
};

}  // namespace place_recognition
