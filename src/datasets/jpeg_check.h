#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

/// Whether a JPEG image contains the data of every block. Decoders silently fill missing blocks
/// with grey. A missing end marker, or bytes after it, are accepted. Thread-safe.
bool isWholeJpeg(const std::uint8_t* bytes, std::size_t size);

}  // namespace place_recognition
