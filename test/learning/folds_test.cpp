#include "learning/folds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace place_recognition {
namespace {

/// `length` samples of each of `places` in each of `runs`, in a shuffled but fixed order; stamps
/// within a run and place are 0, 1, 2, ...
std::vector<SampleOrigin> samplesOf(int runs, int places, int length) {
  std::vector<SampleOrigin> samples;
  for (int stamp = 0; stamp < length; ++stamp) {
    for (int run = 0; run < runs; ++run) {
      for (int place = 0; place < places; ++place) {
        samples.push_back({place, run, static_cast<double>((7 * stamp) % length)});
      }
    }
  }
  return samples;
}

void expectEachTestedOnce(const std::vector<Fold>& folds, std::size_t count) {
  std::multiset<int> tested;
  for (const Fold& fold : folds) {
    tested.insert(fold.test.begin(), fold.test.end());
    for (const int index : fold.test) {
      EXPECT_EQ(std::count(fold.train.begin(), fold.train.end(), index), 0);
    }
  }
  ASSERT_EQ(tested.size(), count);
  for (int i = 0; i < static_cast<int>(count); ++i) EXPECT_EQ(tested.count(i), 1u);
}

TEST(Folds, AreBlocksOfTimeWithGaps) {
  const std::vector<SampleOrigin> samples = samplesOf(2, 3, 23);
  const int gap = 2;
  const std::vector<Fold> folds = timeBlockFolds(samples, 5, gap);
  ASSERT_EQ(folds.size(), 5u);
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    EXPECT_NEAR(static_cast<double>(fold.test.size()), samples.size() / 5.0, 6);
    for (const int test : fold.test) {
      for (const int train : fold.train) {
        const SampleOrigin& a = samples[static_cast<std::size_t>(test)];
        const SampleOrigin& b = samples[static_cast<std::size_t>(train)];
        if (a.run == b.run && a.place == b.place) {
          EXPECT_GT(std::abs(a.stamp - b.stamp), gap);
        }
      }
    }
    // Nothing further away than the gap is wasted: 6 sequences lose at most two gaps each.
    EXPECT_GE(fold.train.size() + fold.test.size() + 6 * 2 * gap, samples.size());
  }
}

TEST(Folds, WorkForFewSamples) {
  for (int length = 0; length <= 6; ++length) {
    const std::vector<SampleOrigin> samples = samplesOf(1, 2, length);
    expectEachTestedOnce(timeBlockFolds(samples, 5, 1), samples.size());
  }
}

TEST(Folds, AreWholeRunsWhenEnoughHoldEveryPlace) {
  std::vector<SampleOrigin> samples = samplesOf(4, 2, 5);
  samples.push_back({0, 9, 0});  // a run of one place only
  const std::vector<Fold> folds = timeBlockFolds(samples, 3, 1);
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    EXPECT_EQ(fold.train.size() + fold.test.size(), samples.size());
    EXPECT_FALSE(fold.test.empty());
    std::set<int> trained;
    for (const int train : fold.train) trained.insert(samples[static_cast<std::size_t>(train)].run);
    for (const int test : fold.test) {
      EXPECT_EQ(trained.count(samples[static_cast<std::size_t>(test)].run), 0u);
    }
  }
}

TEST(Folds, AreBlocksWhenRunsLackPlaces) {
  // Three runs, but place 1 is in one of them only: whole runs would leave it untrained.
  std::vector<SampleOrigin> samples = samplesOf(1, 2, 9);
  for (int i = 0; i < 9; ++i) {
    samples.push_back({0, 1, static_cast<double>(i)});
    samples.push_back({0, 2, static_cast<double>(i)});
  }
  for (const Fold& fold : timeBlockFolds(samples, 3, 1)) {
    std::set<int> places;
    for (const int train : fold.train)
      places.insert(samples[static_cast<std::size_t>(train)].place);
    EXPECT_EQ(places.size(), 2u);
  }
}

}  // namespace
}  // namespace place_recognition
