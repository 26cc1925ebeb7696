#pragma once

#include <cstdint>
#include <string>

namespace place_recognition {

/// For a process that does nothing but read the bag at `path`: limits its memory and lets a crash
/// or an endless loop end it with a kCrash record on standard output.
void guardBag(const std::string& path);

/// Gives the work up to the next call 60 seconds of processor time.
void restartWorkLimit();

/// How many bytes of the bag have been passed; 0 if it is not open. From signal handlers too.
std::uint64_t bagOffset();

}  // namespace place_recognition
