#pragma once

#include "place_recognition/error.h"

namespace place_recognition {

/// Throws Error saying `otherwise`, text or a literal, unless `condition` holds.
template <typename Text>
void require(bool condition, const Text& otherwise) {
  if (!condition) throw Error(otherwise);
}

}  // namespace place_recognition
