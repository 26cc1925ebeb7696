#pragma once

#include <cstdint>
#include <string>

namespace place_recognition {

/// The address space that reading a bag may take; the largest image needs a tenth of it.
constexpr std::uint64_t kMaxMemory = std::uint64_t{4} << 30;

/// For a process that does nothing but read the bag at `path`: limits its memory, and lets a crash
/// or an endless loop end it with a kCrash record on standard output.
void guardBag(const std::string& path);

/// Gives the work up to the next call 60 seconds of processor time.
void restartWorkLimit();

/// How many bytes of the bag have been passed; 0 if it is not open. From signal handlers too.
std::uint64_t bagOffset();

}  // namespace place_recognition
