#include "base/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
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

/// Leaves the process address space for few threads.
void allowFewThreads() {
  std::ifstream statistics("/proc/self/statm");
  rlim_t pages = 0;
  statistics >> pages;
  const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (40 << 20);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

TEST(ParallelForDeathTest, DoesTheWorkWithTheThreadsThatItGets) {
  const auto work = [] {
    allowFewThreads();
    std::atomic<int> calls{0};
    parallelFor(1000, 500, [&](std::size_t, unsigned) { ++calls; });
    _exit(calls == 1000 ? 0 : 1);
  };
  EXPECT_EXIT(work(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace place_recognition
