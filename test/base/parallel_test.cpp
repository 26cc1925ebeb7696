#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace place_recognition {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    std::vector<std::atomic<int>> calls(1000);
    parallelFor(calls.size(), threads, [&](std::size_t i, unsigned thread) {
      EXPECT_LT(thread, threads);
      ++calls[i];
    });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, DoesNothingForNoWork) {
  parallelFor(0, 4, [](std::size_t, unsigned) { FAIL(); });
}

TEST(ParallelFor, ThrowsAgainWhatTheWorkThrew) {
  std::atomic<int> calls{0};
  const auto work = [&](std::size_t i, unsigned) {
    ++calls;
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(parallelFor(100000, 2, work), std::runtime_error);
  EXPECT_LT(calls, 100000);
}

}  // namespace
}  // namespace place_recognition
