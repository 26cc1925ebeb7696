#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// Mean and sample standard deviation; the latter is 0 for a single value.
struct Spread {
  double mean = 0;
  double deviation = 0;
};

Spread spreadOf(const std::vector<double>& values);

/// Such as "75.44 +- 4.90" with two decimals.
std::string plusMinus(const Spread& spread, int decimals);

}  // namespace place_recognition
