#pragma once

#include <cstdint>

namespace place_recognition {

// Limits for a process that only reads a file, which may come from anywhere.

/// Address space for reading a bag or a network; the largest image needs a tenth of it.
constexpr std::uint64_t kMaxMemory = std::uint64_t{4} << 30;

/// Limits this process to kMaxMemory and prevents core files.
void limitMemory();

/// The same; also ends the process after `seconds` of processor time.
void limitProcess(unsigned seconds);

}  // namespace place_recognition
