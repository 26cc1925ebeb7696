#pragma once

#include <cstdlib>

namespace place_recognition {

/// How often a test of random damage repeats: `quick` times, or `full` times where the environment
/// asks for it, as `./scripts/test --full` does.
inline int rounds(int quick, int full) {
  return std::getenv("PLACE_RECOGNITION_FULL_TEST") ? full : quick;
}

}  // namespace place_recognition
