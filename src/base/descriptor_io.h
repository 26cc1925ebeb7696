#pragma once

#include <cstddef>

namespace place_recognition {

/// Writes all bytes to a file or pipe; false, with errno, if that fails. Async-signal-safe.
bool writeAll(int fd, const void* bytes, std::size_t count);

/// Reads until there are `count` bytes, the end, or a failure. Returns the number read; errno is 0
/// unless reading failed.
std::size_t readAll(int fd, void* bytes, std::size_t count);

}  // namespace place_recognition
