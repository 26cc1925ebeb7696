#include "tuning/tuning_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "recognition/drawn_run.h"
#include "tuning/thinned_run.h"

namespace place_recognition {
namespace {

const std::vector<RunOpener> kNone;

TuningSamples collect(const std::vector<RunOpener>& runs, const std::vector<RunOpener>& hold_out,
                      std::size_t step = 1) {
  TrainingOptions options = quickOptions();
  options.augmentation.other_light = true;
  return collectTuningSamples({runs, hold_out}, options, step, 2, {});
}

/// Places of `indices` by run.
std::set<int> runsOf(const TuningSamples& samples, const std::vector<int>& indices) {
  std::set<int> runs;
  for (const int i : indices) runs.insert(samples.origins[i].run);
  return runs;
}

TEST(TuningSamples, EveryPictureIsThereInTwoLights) {
  const TuningSamples samples = collect({opener(drawFrames(2, 10))}, kNone);
  ASSERT_EQ(samples.recorded, 20u);
  ASSERT_EQ(samples.origins.size(), 40u);
  for (std::size_t i = 0; i < samples.origins.size(); ++i) {
    EXPECT_EQ(samples.source[i], static_cast<int>(i % 20));
    EXPECT_EQ(samples.origins[i].place, samples.origins[i % 20].place);
    EXPECT_EQ(samples.origins[i].run, 0);
  }
}

TEST(TuningSamples, WhatIsTestedInAnyLightIsTrainedOnInNone) {
  const TuningSamples samples = collect({opener(drawFrames(2, 10))}, kNone);
  std::size_t tested = 0;
  for (const Fold& fold : samples.folds) {
    const std::set<int> train(fold.train.begin(), fold.train.end());
    for (const int i : fold.train) EXPECT_LT(i, 20) << "trained on in the recorded light only";
    for (const int i : fold.test) EXPECT_EQ(train.count(samples.source[i]), 0u);
    tested += fold.test.size();
  }
  EXPECT_EQ(tested, samples.origins.size());
}

TEST(TuningSamples, WholeRunsAreTheFoldsIfTwoHoldEveryPlace) {
  const TuningSamples samples =
      collect({opener(drawFrames(2, 6), "a"), opener(drawFrames(2, 6, 100), "b")}, kNone);
  ASSERT_EQ(samples.folds.size(), 2u);
  for (const Fold& fold : samples.folds) {
    EXPECT_EQ(runsOf(samples, fold.train).size(), 1u);
    EXPECT_EQ(runsOf(samples, fold.test).size(), 1u);
    EXPECT_NE(runsOf(samples, fold.train), runsOf(samples, fold.test));
  }
}

TEST(TuningSamples, HeldOutRunsAreTestedAndNeverTrainedOn) {
  const TuningSamples samples =
      collect({opener(drawFrames(2, 6), "a")}, {opener(drawFrames(2, 4, 100), "b")});
  ASSERT_EQ(samples.folds.size(), 1u);
  EXPECT_EQ(runsOf(samples, samples.folds[0].train), std::set<int>{0});
  EXPECT_EQ(runsOf(samples, samples.folds[0].test), std::set<int>{1});
  EXPECT_EQ(samples.folds[0].test.size(), 16u);
}

TEST(ThinnedRun, KeepsOneOfEveryThreeLabelledFramesOfEachPlace) {
  std::vector<Frame> frames = drawFrames(2, 30);
  frames[1].place.clear();
  const auto keptNames = [&](std::uint64_t seed) {
    const auto run = thinOut(opener(frames)(), 3, seed);
    std::vector<std::string> kept;
    for (Frame frame; run->next(frame);) {
      EXPECT_FALSE(frame.place.empty());
      kept.push_back(frame.name);
    }
    return kept;
  };
  const std::vector<std::string> kept = keptNames(1);
  EXPECT_NEAR(static_cast<double>(kept.size()), 20, 1);  // 29 frames do not end with a stretch
  EXPECT_EQ(kept[0], "frame0");
  EXPECT_EQ(std::count(kept.begin(), kept.end(), "frame30"), 1);  // the first of its place
  EXPECT_EQ(keptNames(1), kept);
  EXPECT_NE(keptNames(2), kept);
}

}  // namespace
}  // namespace place_recognition
