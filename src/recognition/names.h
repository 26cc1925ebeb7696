#pragma once

#include <cstddef>
#include <string>

namespace place_recognition {

/// What a model may know at most; what is kept of pairs of places takes memory by its square.
constexpr std::size_t kMaxPlaces = 2000;

/// Whether `text` is well-formed UTF-8 (RFC 3629).
bool isUtf8(const std::string& text);

/// Whether `name` can name a place: 1 to 128 bytes of valid UTF-8 without control characters. Such
/// names pass through messages, JSON, YAML and file listings unchanged.
bool isPlaceName(const std::string& name);

/// Whether `name` is [A-Za-z0-9_-]{1,64}: models and cues, whose names become parts of paths and of
/// option keys.
bool isPlainName(const std::string& name);

}  // namespace place_recognition
