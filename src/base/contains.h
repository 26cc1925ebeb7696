#pragma once

#include <algorithm>
#include <iterator>

namespace place_recognition {

/// Whether an element of `range`, such as a vector or an array, equals `value`.
template <typename Range, typename Value>
bool contains(const Range& range, const Value& value) {
  return std::find(std::begin(range), std::end(range), value) != std::end(range);
}

}  // namespace place_recognition
