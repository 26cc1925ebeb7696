#pragma once

#include <algorithm>
#include <cstdint>

namespace place_recognition {

/// The values that nearly all pixels of a camera's images of 16 bits per channel lie between.
/// Infrared, thermal and machine vision cameras use 10 to 14 of the 16 bits, so images are brought
/// to 8 bits by what a camera uses: by the extent that a model was trained on, so that a level
/// means the same.
struct DepthExtent {
  std::uint32_t low = 0;   ///< 0..65535
  std::uint32_t high = 0;  ///< low..65535; 0: not known, as of cameras of 8 bits

  bool known() const { return high > 0; }
};

/// What holds both; an extent that is not known adds nothing.
inline DepthExtent united(const DepthExtent& a, const DepthExtent& b) {
  if (!a.known() || !b.known()) return a.known() ? a : b;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace place_recognition
