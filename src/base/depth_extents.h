#pragma once

#include <algorithm>

#include "place_recognition/depth_extent.h"

namespace place_recognition {

/// What holds both; an extent that is not known adds nothing.
inline DepthExtent united(const DepthExtent& a, const DepthExtent& b) {
  if (!a.known() || !b.known()) return a.known() ? a : b;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace place_recognition
