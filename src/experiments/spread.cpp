#include "experiments/spread.h"

#include <cmath>

#include "base/text.h"

namespace place_recognition {

Spread spreadOf(const std::vector<double>& values) {
  Spread spread;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) spread.mean += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  if (n > 1) spread.deviation = std::sqrt(squares / (n - 1));
  return spread;
}

std::string plusMinus(const Spread& spread, int decimals) {
  return fixed(spread.mean, decimals) + " +- " + fixed(spread.deviation, decimals);
}

}  // namespace place_recognition
