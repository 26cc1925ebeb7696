#include "base/place_name.h"

#include <cstdint>
#include <map>

#include "base/text.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxPlaceNameBytes = 128;

/// Decodes the character at `i` and advances `i` past it; false if it is not well-formed UTF-8 (RFC
/// 3629: no overlong forms, no surrogates, at most U+10FFFF).
bool decode(const std::string& text, std::size_t& i, std::uint32_t& character) {
  const auto byte = [&text](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned char first = byte(i);
  const int length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if ((first >= 0x80 && first < 0xc2) || first > 0xf4 || i + length > text.size()) return false;
  character = length == 1 ? first : first & (0x7f >> length);
  for (int k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xc0) != 0x80) return false;
    character = character << 6 | (byte(i + k) & 0x3f);
  }
  const bool overlong = (length == 3 && character < 0x800) || (length == 4 && character < 0x10000);
  const bool surrogate = character >= 0xd800 && character < 0xe000;
  i += length;
  return !overlong && !surrogate && character <= 0x10ffff;
}

}  // namespace

bool isUtf8(const std::string& text) {
  std::uint32_t character = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (!decode(text, i, character)) return false;
  }
  return true;
}

bool isPlaceName(const std::string& name) {
  if (name.empty() || name.size() > kMaxPlaceNameBytes) return false;
  for (std::size_t i = 0; i < name.size();) {
    std::uint32_t character = 0;
    if (!decode(name, i, character)) return false;
    const bool control = character < 0x20 || (character >= 0x7f && character < 0xa0);
    if (control) return false;
  }
  return true;
}

std::string placeName(const std::string& text) { return isUtf8(text) ? tidied(text) : text; }

std::string whyNoPlaceName(const std::string& text) {
  if (!isUtf8(text)) return "is not a place name because it is not UTF-8; save it as UTF-8.";
  const std::string name = placeName(text);
  if (!isPlaceName(name)) {
    return "is not a place name (1 to 128 bytes of UTF-8 without control characters); rename the "
           "place.";
  }
  if (caseFolded(name) == kUnknownPlace) {
    return "is reserved for unknown places; rename the place, or leave it unlabelled.";
  }
  return "";
}

std::vector<std::string> warnOfLikeNames(const std::vector<std::string>& names) {
  std::vector<std::string> warnings;
  std::map<std::string, std::string> seen;
  for (const std::string& name : names) {
    const auto [first, is_new] = seen.emplace(likeness(name), name);
    if (is_new || first->second == name) continue;
    const bool in_case = caseFolded(first->second) == caseFolded(name);
    warnings.push_back("'" + first->second + "' and '" + name + "' " +
                       (in_case ? "differ only in upper and lower case" : "look alike") +
                       " but are two places; rename one of them if they are the same room.");
  }
  return warnings;
}

}  // namespace place_recognition
