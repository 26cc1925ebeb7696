#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace place_recognition {

/// Maximum number of places in a model; memory for pairs of places grows with its square.
constexpr std::size_t kMaxPlaces = 2000;

/// The answer for an unknown place; no place may have this name, in upper or lower case.
constexpr const char* kUnknownPlace = "unknown";

/// Whether `text` is well-formed UTF-8 (RFC 3629).
bool isUtf8(const std::string& text);

/// Whether `name` can name a place: 1 to 128 bytes of valid UTF-8 without control characters. Such
/// names pass through messages, JSON, YAML and file listings unchanged.
bool isPlaceName(const std::string& name);

/// Normalizes `text` as the name of a place: composed (Unicode NFC), with single blanks inside and
/// none at the ends, so that two spellings of one room are one place. Text that is not UTF-8 is
/// returned unchanged.
std::string placeName(const std::string& text);

/// Why placeName() of `text` cannot name a place to learn, and what to do: a sentence that
/// continues after the name. Empty if it can.
std::string whyNoPlaceName(const std::string& text);

/// One sentence for every two of `names` that may mean the same place: they differ only in upper
/// and lower case, or are alike (see likeness()).
std::vector<std::string> warnOfLikeNames(const std::vector<std::string>& names);

}  // namespace place_recognition
