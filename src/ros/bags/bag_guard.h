#pragma once

#include <cstdint>
#include <string>

namespace place_recognition {

/// For a process that only reads the bag at `path`: limits its memory, and makes a crash or an
/// endless loop end it with a kCrash record on standard output.
void guardBag(const std::string& path);

/// Limits the work until the next call to 60 seconds of processor time.
void restartWorkLimit();

/// Number of bytes of the bag read so far; 0 if it is not open. Safe in signal handlers.
std::uint64_t bagOffset();

}  // namespace place_recognition
