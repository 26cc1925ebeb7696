#include "learning/folds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace place_recognition {
namespace {

/// Returns `length` samples of each of `places` in each of `recordings`, in a fixed shuffled order.
/// The stamps within a run and place are 0, 1, 2, ...
std::vector<SampleOrigin> samplesOf(int recordings, int places, int length) {
  std::vector<SampleOrigin> samples;
  for (int stamp = 0; stamp < length; ++stamp) {
    for (int recording = 0; recording < recordings; ++recording) {
      for (int place = 0; place < places; ++place) {
        samples.push_back({place, recording, static_cast<double>((7 * stamp) % length)});
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

/// The same blocks for ten runs.
std::vector<TimeBlocks> blocks(double length, double gap) {
  return std::vector<TimeBlocks>(10, TimeBlocks{length, gap});
}

/// Returns samples of one room, `step` s apart.
std::vector<SampleOrigin> roomAt(double start, double step, int length, int place = 0) {
  std::vector<SampleOrigin> samples;
  for (int i = 0; i < length; ++i) samples.push_back({place, 0, start + step * i});
  return samples;
}

/// Returns the time between a test sample of a fold and the nearest training sample of the same run
/// and place, s.
double nearestTrained(const std::vector<SampleOrigin>& samples, const Fold& fold, int test) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int train : fold.train) {
    const SampleOrigin& a = samples[static_cast<std::size_t>(test)];
    const SampleOrigin& b = samples[static_cast<std::size_t>(train)];
    if (a.recording != b.recording || a.place != b.place) continue;
    nearest = std::min(nearest, std::abs(a.stamp - b.stamp));
  }
  return nearest;
}

TEST(Folds, AreShortBlocksOfTimeInTurnWithGaps) {
  // Five frames per second for a minute, with stamps of a real clock: blocks of 0.4 s.
  const std::vector<SampleOrigin> samples = roomAt(1.7e9, 0.2, 300);
  const std::vector<Fold> folds = timeBlockFolds(samples, 5, blocks(0.4, 0.3));
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    EXPECT_EQ(fold.test.size(), 60u);
    EXPECT_NEAR(static_cast<double>(fold.train.size()), 180, 1);  // two more frames on each side
    for (const int test : fold.test) {
      EXPECT_GE(nearestTrained(samples, fold, test), 0.4 - 1e-6);
      EXPECT_LE(nearestTrained(samples, fold, test), 0.6 + 1e-6);  // at either end of the recording
    }
  }
}

TEST(Folds, LeaveOutWhatIsBehindTheDoorToo) {
  // A drive through three rooms, half a minute in each, at five frames per second.
  std::vector<SampleOrigin> samples;
  for (int place = 0; place < 3; ++place) {
    for (const SampleOrigin& sample : roomAt(30 * place, 0.2, 150, place)) {
      samples.push_back(sample);
    }
  }
  samples.push_back({1, 1, 30});  // another run, with its own clock
  const std::vector<Fold> folds = timeBlockFolds(samples, 5, blocks(1, 0.9));
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    for (const int test : fold.test) {
      for (const int train : fold.train) {
        if (samples[train].recording != samples[test].recording) continue;
        EXPECT_GT(std::abs(samples[train].stamp - samples[test].stamp), 0.9);
      }
    }
  }
}

TEST(Folds, TrainOnWhatLiesBetweenTwoVisitsToARoom) {
  // Ten laps through five rooms, 7 s in each: some blocks of 4 s end one visit and begin the next.
  std::vector<SampleOrigin> samples;
  for (int visit = 0; visit < 50; ++visit) {
    for (const SampleOrigin& sample : roomAt(7 * visit, 1, 7, visit % 5)) samples.push_back(sample);
  }
  constexpr double kGap = 2;
  const std::vector<Fold> folds = timeBlockFolds(samples, 5, blocks(4, kGap));
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
      const bool near = std::any_of(fold.test.begin(), fold.test.end(), [&](int test) {
        return std::abs(samples[test].stamp - samples[i].stamp) <= kGap;
      });
      EXPECT_EQ(std::count(fold.train.begin(), fold.train.end(), i), near ? 0 : 1) << i;
    }
  }
}

TEST(Folds, OfSeveralCamerasAreThoseOfOneForEachMoment) {
  const std::vector<SampleOrigin> alone = roomAt(5, 0.2, 303);
  std::vector<SampleOrigin> together;
  for (const SampleOrigin& sample : alone) {
    for (const int camera : {0, 1, 2}) together.push_back({0, 0, sample.stamp, camera});
  }
  const std::vector<Fold> expected = timeBlockFolds(alone, 5, blocks(0.7, 0.5));
  const std::vector<Fold> folds = timeBlockFolds(together, 5, blocks(0.7, 0.5));
  for (std::size_t f = 0; f < folds.size(); ++f) {
    std::vector<int> test, train;
    for (const int i : folds[f].test) test.push_back(i / 3);
    for (const int i : folds[f].train) train.push_back(i / 3);
    test.erase(std::unique(test.begin(), test.end()), test.end());
    train.erase(std::unique(train.begin(), train.end()), train.end());
    EXPECT_EQ(test, expected[f].test);
    EXPECT_EQ(train, expected[f].train);
    EXPECT_EQ(folds[f].test.size(), 3 * test.size());
  }
}

TEST(Folds, LeaveTwoFifthsToTrainOnAtTheLargestGap) {
  const std::vector<SampleOrigin> samples = roomAt(0, 0.01, 6000);
  for (const int count : {2, 3, 5, 20}) {
    for (const Fold& fold : timeBlockFolds(samples, count, blocks(1, largestGap(1, count)))) {
      EXPECT_GT(static_cast<double>(fold.train.size()), 0.38 * 6000) << count;
      EXPECT_LT(static_cast<double>(fold.train.size()), 0.5 * 6000) << count;  // the ends lose less
    }
  }
}

TEST(Folds, AreLeaveOneOutWhenThereAreAsManyAsSamples) {
  std::vector<SampleOrigin> samples = roomAt(0, 1, 12, 0);
  for (const SampleOrigin& sample : roomAt(12, 1, 12, 1)) samples.push_back(sample);
  const std::vector<Fold> folds = timeBlockFolds(samples, 24, blocks(0, 0));
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    EXPECT_EQ(fold.test.size(), 1u);
    EXPECT_EQ(fold.train.size(), samples.size() - 1);
  }
}

TEST(Folds, CutEveryRoomIntoAsManyBlocksAtLeast) {
  const std::vector<SampleOrigin> samples = samplesOf(2, 3, 23);
  const double gap = 2;
  const std::vector<Fold> folds = timeBlockFolds(samples, 5, blocks(1e6, gap));
  ASSERT_EQ(folds.size(), 5u);
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    EXPECT_NEAR(static_cast<double>(fold.test.size()), samples.size() / 5.0, 6);
    for (const int test : fold.test) EXPECT_GT(nearestTrained(samples, fold, test), gap);
    // Samples beyond the gap are kept: 6 sequences lose at most two gaps each.
    EXPECT_GE(fold.train.size() + fold.test.size() + 6 * 2 * gap, samples.size());
  }
}

TEST(Folds, LeaveSmallRoomsSomethingToLearnFrom) {
  // A gap of one minute, and a room that was seen for only ten seconds.
  std::vector<SampleOrigin> samples = roomAt(0, 1, 600);
  for (const SampleOrigin& sample : roomAt(600, 1, 10, 1)) samples.push_back(sample);
  for (const Fold& fold : timeBlockFolds(samples, 5, blocks(60, 60))) {
    std::set<int> trained;
    for (const int i : fold.train) trained.insert(samples[static_cast<std::size_t>(i)].place);
    EXPECT_EQ(trained.size(), 2u);
  }
}

TEST(Folds, CountSamplesWhoseStampsTellNothing) {
  const std::vector<SampleOrigin> samples = roomAt(0, 0, 50);
  const std::vector<Fold> folds = timeBlockFolds(samples, 5, blocks(1.5, 1.5));
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) EXPECT_NEAR(static_cast<double>(fold.train.size()), 30, 1);
}

TEST(Folds, OfTheLongestBlocksCutEveryRoomOfEveryRunIntoOneEach) {
  std::vector<SampleOrigin> samples = roomAt(0, 1, 20);
  for (SampleOrigin sample : roomAt(100, 1, 10, 1)) {
    sample.recording = 1;
    samples.push_back(sample);
  }
  EXPECT_EQ(recordingCount(samples), 2);
  const std::vector<Fold> folds = longestBlockFolds(samples, 5, 1);
  const std::vector<int> tested_in = testingFolds(folds, samples.size() + 1);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(tested_in[i], i < 20 ? i / 4 : (i - 20) / 2) << i;
  EXPECT_EQ(tested_in.back(), -1) << "a sample of no fold";
  EXPECT_EQ(folds[1].train.size(), 20u - 6 + 10 - 4) << "without a neighbour on either side";
}

TEST(Folds, WorkForFewSamples) {
  for (int length = 0; length <= 6; ++length) {
    const std::vector<SampleOrigin> samples = samplesOf(1, 2, length);
    expectEachTestedOnce(timeBlockFolds(samples, 5, blocks(2, 1)), samples.size());
  }
}

TEST(Folds, AreWholeRunsWhenEnoughHoldEveryPlace) {
  std::vector<SampleOrigin> samples = samplesOf(4, 2, 5);
  samples.push_back({0, 9, 0});  // a run of one place only
  EXPECT_EQ(completeRecordings(samples), 4);
  const std::vector<Fold> folds = timeBlockFolds(samples, 3, blocks(1, 1));
  expectEachTestedOnce(folds, samples.size());
  for (const Fold& fold : folds) {
    EXPECT_EQ(fold.train.size() + fold.test.size(), samples.size());
    EXPECT_FALSE(fold.test.empty());
    std::set<int> trained;
    for (const int train : fold.train)
      trained.insert(samples[static_cast<std::size_t>(train)].recording);
    for (const int test : fold.test) {
      EXPECT_EQ(trained.count(samples[static_cast<std::size_t>(test)].recording), 0u);
    }
  }
}

TEST(Folds, AreBlocksWhenRunsLackPlaces) {
  // Three runs, but place 1 is in only one of them: whole runs would leave it untrained.
  std::vector<SampleOrigin> samples = samplesOf(1, 2, 9);
  for (int i = 0; i < 9; ++i) {
    samples.push_back({0, 1, static_cast<double>(i)});
    samples.push_back({0, 2, static_cast<double>(i)});
  }
  EXPECT_EQ(completeRecordings(samples), 1);
  for (const Fold& fold : timeBlockFolds(samples, 3, blocks(1, 1))) {
    std::set<int> places;
    for (const int train : fold.train)
      places.insert(samples[static_cast<std::size_t>(train)].place);
    EXPECT_EQ(places.size(), 2u);
  }
}

}  // namespace
}  // namespace place_recognition
