#include "tuning/lit_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "recognition/drawn_run.h"

namespace place_recognition {
namespace {

const std::vector<RunOpener> kNone;

LitSamples collect(const std::vector<RunOpener>& runs, const std::vector<RunOpener>& hold_out,
                   std::size_t step = 1) {
  return collectLitSamples({runs, hold_out}, quickOptions(), step, lightsToJudge(true), 2, {});
}

/// Places of `indices` by run.
std::set<int> runsOf(const LitSamples& samples, const std::vector<int>& indices) {
  std::set<int> runs;
  for (const int i : indices) runs.insert(samples.origins[i].run);
  return runs;
}

TEST(LitSamples, EveryPictureIsThereInEveryLight) {
  const LitSamples samples = collect({opener(drawFrames(2, 10))}, kNone);
  const std::size_t lights = lightsToJudge(true).size();
  ASSERT_EQ(samples.recorded, 20u);
  ASSERT_EQ(samples.origins.size(), 20 * lights);
  for (std::size_t i = 0; i < samples.origins.size(); ++i) {
    EXPECT_EQ(samples.source[i], static_cast<int>(i % 20));
    EXPECT_EQ(samples.origins[i].place, samples.origins[i % 20].place);
    EXPECT_EQ(samples.origins[i].run, 0);
  }
}

TEST(LitSamples, WhatIsTestedInAnyLightIsTrainedOnInNone) {
  const LitSamples samples = collect({opener(drawFrames(2, 10))}, kNone);
  std::size_t tested = 0;
  for (const Fold& fold : samples.folds) {
    const std::set<int> train(fold.train.begin(), fold.train.end());
    for (const int i : fold.train) EXPECT_LT(i, 20) << "trained on in the recorded light only";
    for (const int i : fold.test) EXPECT_EQ(train.count(samples.source[i]), 0u);
    tested += fold.test.size();
  }
  EXPECT_EQ(tested, samples.origins.size());
}

TEST(LitSamples, WholeRunsAreTheFoldsIfTwoHoldEveryPlace) {
  const LitSamples samples =
      collect({opener(drawFrames(2, 6), "a"), opener(drawFrames(2, 6, 100), "b")}, kNone);
  ASSERT_EQ(samples.folds.size(), 2u);
  for (const Fold& fold : samples.folds) {
    EXPECT_EQ(runsOf(samples, fold.train).size(), 1u);
    EXPECT_EQ(runsOf(samples, fold.test).size(), 1u);
    EXPECT_NE(runsOf(samples, fold.train), runsOf(samples, fold.test));
  }
}

TEST(LitSamples, HeldOutRunsAreTestedAndNeverTrainedOn) {
  const LitSamples samples =
      collect({opener(drawFrames(2, 6), "a")}, {opener(drawFrames(2, 4, 100), "b")});
  ASSERT_EQ(samples.folds.size(), 1u);
  EXPECT_EQ(runsOf(samples, samples.folds[0].train), std::set<int>{0});
  EXPECT_EQ(runsOf(samples, samples.folds[0].test), std::set<int>{1});
  EXPECT_EQ(samples.folds[0].test.size(), 8 * lightsToJudge(true).size());
}

}  // namespace
}  // namespace place_recognition
