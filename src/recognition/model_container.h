#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace place_recognition {

// The outside of a model file: 8 bytes of magic, then little-endian the format version (4 bytes),
// the length of the payload (8) and its CRC-32 (4), then the payload. Any change of any byte is
// noticed before the payload is looked at.

/// Of a model file; protobuf's own limit.
constexpr std::size_t kMaxModelBytes = std::numeric_limits<int>::max();

/// `payload` with its header.
std::string packContainer(std::string_view payload);

/// The payload inside `bytes`, as a part of them. Throws Error naming `where` if they are not a
/// whole, unchanged model file of the known format version.
std::string_view unpackContainer(std::string_view bytes, const std::string& where);

/// The checksum of a packed container as 8 hexadecimal digits.
std::string containerVersion(std::string_view bytes);

}  // namespace place_recognition
