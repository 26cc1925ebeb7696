#pragma once

#include <chrono>
#include <thread>

namespace place_recognition {

/// Returns whether `condition` becomes true within `seconds` of wall time.
template <typename Condition>
bool eventually(Condition condition, double seconds = 15) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace place_recognition
