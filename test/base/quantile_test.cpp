#include "base/quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace place_recognition {
namespace {

TEST(Quantile, HasAtMostTheFractionOfTheValuesBelowIt) {
  const std::vector<double> values{5, 1, 4, 2, 3, 3, 9, 7, 8, 6};
  for (const double fraction : {0.0, 0.05, 0.1, 0.49, 0.5, 0.99, 1.0}) {
    const double limit = quantile(values, fraction);
    const auto below = std::count_if(values.begin(), values.end(),
                                     [limit](double value) { return value < limit; });
    EXPECT_LE(static_cast<double>(below), fraction * 10) << fraction;
  }
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.2), 3);
  EXPECT_EQ(quantile(values, 1), 9);
  EXPECT_EQ(quantile({5, 1, 3, 2, 4}, 0.5), 3);
  EXPECT_EQ(quantile({5, 1, 3, 2, 4}, 0.95), 5);
  EXPECT_EQ(quantile({5, 1, 3, 2, 4}, 0.19), 1);
  EXPECT_EQ(quantile({5, 1, 3, 2, 4}, 0.2), 2);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(Quantile, OfAHalfIsTheMedian) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_EQ(median({}), 0);
}

}  // namespace
}  // namespace place_recognition
