#pragma once

#include <algorithm>
#include <cstdint>

namespace place_recognition {

/// The range that contains nearly all pixel values of a camera with 16 bits per channel. Infrared,
/// thermal and machine vision cameras use 10 to 14 of the 16 bits. Images are converted to 8 bits
/// with the range that the model was trained on, so that a level keeps its meaning.
struct LevelRange {
  std::uint32_t low = 0;   ///< 0..65535
  std::uint32_t high = 0;  ///< low..65535; 0: unknown, as for cameras with 8 bits

  bool known() const { return high > 0; }
};

/// The smallest range that contains both; an unknown range adds nothing.
inline LevelRange united(const LevelRange& a, const LevelRange& b) {
  if (!a.known() || !b.known()) return a.known() ? a : b;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace place_recognition
