#pragma once

#include <string>

#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {

/// Throws Error with the message `otherwise`, text or a literal, unless `condition` holds.
template <typename Text>
void require(bool condition, const Text& otherwise) {
  if (!condition) throw Error(otherwise);
}

namespace require_detail {

inline std::string asText(const std::string& value) { return inQuotes(value); }
inline std::string asText(double value) { return shortest(value); }
inline std::string asText(int value) { return std::to_string(value); }

}  // namespace require_detail

/// Throws Error unless `is_allowed`, with the `key` of the option as a user writes it, its `value`
/// (a number or text), and what is `allowed`, such as "a number from 0".
template <typename Value>
void requireOption(bool is_allowed, const std::string& key, const Value& value,
                   const std::string& allowed) {
  if (is_allowed) return;
  throw Error("Option '" + key + "' is " + require_detail::asText(value) + "; give " + allowed +
              ".");
}

/// Throws Error if the option `key`, a list or text, is empty; `allowed`: what to give instead.
template <typename Values>
void requireSome(const Values& values, const std::string& key, const std::string& allowed) {
  if (values.empty()) throw Error("Option '" + key + "' is empty; give " + allowed + ".");
}

/// Throws Error if both of two options are set that exclude each other.
inline void requireNotBoth(bool first_is_set, const std::string& first, bool second_is_set,
                           const std::string& second) {
  if (!first_is_set || !second_is_set) return;
  throw Error("Options '" + first + "' and '" + second + "' exclude each other; give one of them.");
}

}  // namespace place_recognition
