#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace place_recognition {

/// What a model may know at most; what is kept of pairs of places takes memory by its square.
constexpr std::size_t kMaxPlaces = 2000;

/// What stands for a place that is not known; no place may be called so, in any case of letters.
constexpr const char* kUnknownPlace = "unknown";

/// Whether `text` is well-formed UTF-8 (RFC 3629).
bool isUtf8(const std::string& text);

/// Whether `name` can name a place: 1 to 128 bytes of valid UTF-8 without control characters. Such
/// names pass through messages, JSON, YAML and file listings unchanged.
bool isPlaceName(const std::string& name);

/// `text` as the name of a place: composed (Unicode NFC), with single blanks inside and none at its
/// ends, so that one room written in two ways is one place. Text that is not UTF-8 is left as it
/// is.
std::string placeName(const std::string& text);

/// Why placeName() of `text` cannot name a place that is learned, and what to do; a sentence that
/// goes on from the name. Empty: it can.
std::string whyNoPlaceName(const std::string& text);

/// A sentence for each two of `names` that may be meant for one place, as they differ in upper and
/// lower case only, or are alike (see likeness()).
std::vector<std::string> warnOfLikeNames(const std::vector<std::string>& names);

}  // namespace place_recognition
