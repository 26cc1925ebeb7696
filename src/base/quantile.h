#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace place_recognition {

/// The value of rank floor(fraction n), counted from 0 in ascending order, or the largest of the n
/// values: at most the `fraction` (0..1) of them lies below it. 0 if there are none.
inline double quantile(std::vector<double> values, double fraction) {
  assert(fraction >= 0 && fraction <= 1);
  if (values.empty()) return 0;
  const auto below = static_cast<std::size_t>(fraction * static_cast<double>(values.size()));
  const auto found =
      values.begin() + static_cast<std::ptrdiff_t>(std::min(below, values.size() - 1));
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

/// The median; of an even number of values, the upper one.
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace place_recognition
