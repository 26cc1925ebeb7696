#pragma once

#include <cstdlib>

namespace place_recognition {

/// Returns the number of rounds of a test of random damage: `quick`, or `full` if the environment
/// asks for it, as `./scripts/test --full` does.
inline int rounds(int quick, int full) {
  return std::getenv("PLACE_RECOGNITION_FULL_TEST") ? full : quick;
}

}  // namespace place_recognition
