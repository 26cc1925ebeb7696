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

TEST(ThinnedRun, KeepsEveryThirdLabelledFrameOfEachPlace) {
  std::vector<Frame> frames = drawFrames(2, 7);
  frames[1].place.clear();  // the others of room0: 0 2 3 4 5 6, so 0 and 4 are kept
  const auto run = thinOut(opener(frames)(), 3);
  std::vector<std::string> kept;
  for (Frame frame; run->next(frame);) kept.push_back(frame.name);
  EXPECT_EQ(kept, (std::vector<std::string>{"frame0", "frame4", "frame7", "frame10", "frame13"}));
}

}  // namespace
}  // namespace place_recognition
