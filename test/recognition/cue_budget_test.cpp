#include "recognition/recognizer/cue_budget.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_recognition {
namespace {

constexpr double kAnyTime = std::numeric_limits<double>::infinity();

/// A budget for cues that take `costs`, s.
class CueBudgetTest : public testing::Test {
 protected:
  /// Computes the cues of a frame that fit into the budget. Returns them in the order of
  /// computation.
  std::vector<std::size_t> frame(double seconds) {
    std::vector<std::size_t> computed;
    budget_.begin(seconds);
    for (const std::size_t cue : budget_.order()) {
      if (!budget_.fits(cue)) {
        budget_.leaveOut(cue);
        continue;
      }
      budget_.time(cue, [&] { now_ += costs_[cue]; });
      computed.push_back(cue);
    }
    return computed;
  }

  double now_ = 1000;
  std::vector<double> costs_{0.004, 0.001, 0.002};
  CueBudget budget_{3, [this] { return now_; }};
};

using Cues = std::vector<std::size_t>;

TEST_F(CueBudgetTest, WithoutALimitAllCuesAreComputed) {
  EXPECT_EQ(frame(kAnyTime), (Cues{0, 1, 2}));
  EXPECT_EQ(frame(kAnyTime), (Cues{1, 2, 0}));  // now their costs are known
}

TEST_F(CueBudgetTest, LeavesOutTheDearest) {
  frame(kAnyTime);
  EXPECT_EQ(frame(0.0071), (Cues{1, 2, 0}));
  EXPECT_EQ(frame(0.0069), (Cues{1, 2}));
  EXPECT_EQ(frame(0.0029), (Cues{1}));
  EXPECT_EQ(frame(0.0009), Cues{});
  EXPECT_EQ(frame(-1), Cues{});
}

TEST_F(CueBudgetTest, TimeThatIsGoneBeforeTheCuesCounts) {
  frame(kAnyTime);
  budget_.begin(0.0071);
  now_ += 0.002;
  EXPECT_TRUE(budget_.fits(1));
  EXPECT_TRUE(budget_.fits(0));
  now_ += 0.002;
  EXPECT_FALSE(budget_.fits(0));
}

TEST_F(CueBudgetTest, ABusyMachineIsNoticedWithinAFrame) {
  frame(kAnyTime);
  for (double& cost : costs_) cost *= 10;
  EXPECT_EQ(frame(0.0121), (Cues{1, 2}));  // 0.01, and 0.002 expected for the next cue
  EXPECT_EQ(frame(0.0121), (Cues{1}));
  EXPECT_EQ(frame(0.009), Cues{});
}

TEST_F(CueBudgetTest, OnceItIsIdleAgainEveryCueReturns) {
  for (double& cost : costs_) cost *= 10;
  frame(kAnyTime);
  for (double& cost : costs_) cost /= 10;
  // The other cues show how much faster the most expensive one has become.
  int frames = 1;
  while (frame(0.008).size() < 3) ASSERT_LT(++frames, 50);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(frame(0.008).size(), 3u);
}

TEST_F(CueBudgetTest, ACueThatWasSlowOnceReturnsLater) {
  costs_[0] *= 10;
  frame(kAnyTime);
  costs_[0] /= 10;
  int frames = 1;
  while (frame(0.008).size() < 3) ASSERT_LT(++frames, 200);
  // Its expected cost, 0.04 s, is multiplied by 0.98 after each frame without it.
  EXPECT_NEAR(frames, std::log(0.04 / 0.005) / -std::log(0.98), 2);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(frame(0.008).size(), 3u);
}

TEST_F(CueBudgetTest, ACueThatNeverFitsIsSeldomTried) {
  costs_[0] = 0.1;
  frame(kAnyTime);
  int tried = 0;
  for (int i = 0; i < 1000; ++i) tried += frame(0.033).size() == 3 ? 1 : 0;
  // After this many frames without it, it is expected to fit.
  const double frames = std::log(0.1 / 0.03) / -std::log(0.98);
  EXPECT_GT(tried, 0);
  EXPECT_LE(tried, 1000 / frames + 1);
}

}  // namespace
}  // namespace place_recognition
