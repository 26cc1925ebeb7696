#pragma once

#include <string>

#include "place_recognition/error.h"

namespace place_recognition {

/// Throws Error with the message `otherwise`, text or a literal, unless `condition` holds.
template <typename Text>
void require(bool condition, const Text& otherwise) {
  if (!condition) throw Error(otherwise);
}

/// Throws Error naming the option and its range, such as "a number from 0", unless `condition`
/// holds.
inline void requireOption(bool condition, const std::string& option, const std::string& range) {
  if (!condition) throw Error("Option '" + option + "' is out of range; give " + range + ".");
}

}  // namespace place_recognition
