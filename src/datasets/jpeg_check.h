#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

/// Whether the data of every block of a JPEG image is there. Decoders fill in grey for what is
/// not, and say nothing. A missing end marker, or bytes behind it, do no harm. Thread-safe.
bool isWholeJpeg(const std::uint8_t* bytes, std::size_t size);

}  // namespace place_recognition
