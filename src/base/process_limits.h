#pragma once

#include <cstdint>

namespace place_recognition {

// Bounds for a process that does nothing but read a file which may come from anywhere.

/// The address space that reading a bag or a network may take; the largest image needs a tenth of
/// it.
constexpr std::uint64_t kMaxMemory = std::uint64_t{4} << 30;

/// Limits this process to kMaxMemory and lets a crash leave no core file.
void limitMemory();

/// The same, and ends it after so many seconds of processor time.
void limitProcess(unsigned seconds);

}  // namespace place_recognition
