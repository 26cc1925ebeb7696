#include "features/bin_counter.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace place_recognition {
namespace {

void expectCounts(BinCounter& counter, const std::map<std::uint64_t, int>& expected, int total) {
  SparseVector histogram;
  counter.histogram(total, histogram);
  ASSERT_EQ(histogram.size(), expected.size());
  std::size_t i = 0;
  for (const auto& [bin, count] : expected) {
    EXPECT_EQ(histogram.indices[i], bin);
    EXPECT_EQ(histogram.values[i], static_cast<float>(static_cast<double>(count) / total));
    ++i;
  }
}

// From a single bin to more than the table's initial capacity, in a small range and the full one.
TEST(BinCounter, CountsAsAMapDoes) {
  std::mt19937_64 random(3);
  BinCounter counter;
  for (std::uint64_t range :
       {std::uint64_t{1}, std::uint64_t{1000}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::map<std::uint64_t, int> expected;
    counter.clear();
    for (int row = 0; row < 60; ++row) {
      std::vector<std::uint64_t> bins(row * 10);
      for (std::uint64_t& bin : bins) {
        bin = random() % range;
        ++expected[bin];
      }
      counter.add(bins.data(), bins.size());
    }
    expectCounts(counter, expected, 60 * 59 / 2 * 10);
  }
}

TEST(BinCounter, KeepsExtremeBinsApart) {
  const std::vector<std::uint64_t> bins = {0, ~std::uint64_t{0} - 1, 0, std::uint64_t{1} << 63};
  BinCounter counter;
  counter.add(bins.data(), bins.size());
  expectCounts(counter, {{0, 2}, {std::uint64_t{1} << 63, 1}, {~std::uint64_t{0} - 1, 1}}, 4);
}

TEST(BinCounter, NothingCountedIsEmpty) {
  BinCounter counter;
  expectCounts(counter, {}, 1);
}

}  // namespace
}  // namespace place_recognition
