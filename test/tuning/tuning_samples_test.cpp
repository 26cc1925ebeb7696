#include "tuning/tuning_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "recognition/drawn_recording.h"
#include "tuning/next_run.h"
#include "tuning/thinned_recording.h"

namespace place_recognition {
namespace {

const std::vector<RecordingOpener> kNone;

TuningSamples collect(const std::vector<RecordingOpener>& recordings,
                      const std::vector<RecordingOpener>& hold_out, std::size_t step = 1) {
  return collectTuningSamples({recordings, hold_out}, quickOptions(), true, step, 2, {});
}

/// Returns the places of `indices`, by run.
std::set<int> runsOf(const TuningSamples& samples, const std::vector<int>& indices) {
  std::set<int> recordings;
  for (const int i : indices) recordings.insert(samples.origins[i].recording);
  return recordings;
}

TEST(TuningSamples, EveryImageIsThereAsRecordedAndChanged) {
  const TuningSamples samples = collect({opener(drawFrames(2, 10))}, kNone);
  ASSERT_EQ(samples.recorded, 20u);
  ASSERT_EQ(samples.origins.size(), 40u);
  for (std::size_t i = 0; i < samples.origins.size(); ++i) {
    EXPECT_EQ(samples.source[i], static_cast<int>(i % 20));
    EXPECT_EQ(samples.origins[i].place, samples.origins[i % 20].place);
    EXPECT_EQ(samples.origins[i].recording, 0);
  }
}

TEST(TuningSamples, WhatIsTestedIsNotTrainedOn) {
  const TuningSamples samples = collect({opener(drawFrames(2, 10))}, kNone);
  std::size_t tested = 0;
  for (const Fold& fold : samples.folds) {
    const std::set<int> train(fold.train.begin(), fold.train.end());
    for (const int i : fold.train) EXPECT_LT(i, 20) << "trained on as recorded only";
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

TEST(TuningSamples, AHeldOutPartIsNotTrainedOnWithTheOtherParts) {
  const std::vector<RecordingOpener> parts = openersOfParts(drawFrames(2, 10), {12});
  const TuningSamples samples = collect({parts[0]}, {parts[1]});
  EXPECT_EQ(samples.folds[0].train.size(), 12u);
  EXPECT_EQ(samples.folds[0].test.size(), 16u);
}

/// Returns the mean of all levels.
double levelOf(const cv::Mat& image) {
  const cv::Scalar mean = cv::mean(image);
  return (mean[0] + mean[1] + mean[2]) / 3;
}

TEST(NextRun, ChangesFramingAndSharpnessAndLightIfAsked) {
  const cv::Mat image = drawRoom(1, 1);
  NextRun same_light(1, false);
  NextRun other_light(1, true);
  bool any_light = false;
  for (int i = 0; i < 8; ++i) {
    const ChangedImage still = same_light.change(image, "room1");
    EXPECT_EQ(still.image.size(), image.size());
    EXPECT_GT(cv::norm(still.image, image, cv::NORM_L1), 0);
    EXPECT_NEAR(levelOf(still.image) / levelOf(image), 1, 0.1);
    EXPECT_EQ(still.correction.red, 1);
    const ChangedImage lit = other_light.change(image, "room1");
    cv::Mat corrected;
    changeLight(lit.image, lit.correction, corrected);
    EXPECT_NEAR(levelOf(corrected) / levelOf(image), 1, 0.2) << "the light is known to a twentieth";
    any_light = any_light || std::abs(levelOf(lit.image) / levelOf(image) - 1) > 0.2;
  }
  EXPECT_TRUE(any_light);
}

TEST(NextRun, IsTheSameForTheSameSeed) {
  const cv::Mat image = drawRoom(1, 1);
  NextRun a(3, true), b(3, true), c(4, true);
  const cv::Mat first = a.change(image, "room1").image;
  EXPECT_EQ(cv::norm(first, b.change(image, "room1").image, cv::NORM_L1), 0);
  EXPECT_NE(cv::norm(first, c.change(image, "room1").image, cv::NORM_L1), 0);
}

TEST(ThinnedRecording, KeepsOneOfEveryThreeLabelledFramesOfEachPlace) {
  std::vector<Frame> frames = drawFrames(2, 30);
  frames[1].place.clear();
  const auto keptNames = [&](std::uint64_t seed) {
    const auto recording = thinOut(opener(frames)(), 3, seed);
    std::vector<std::string> kept;
    for (Frame frame; recording->next(frame);) {
      EXPECT_FALSE(frame.place.empty());
      kept.push_back(frame.name);
    }
    return kept;
  };
  const std::vector<std::string> kept = keptNames(1);
  EXPECT_NEAR(static_cast<double>(kept.size()), 20, 1);  // 29 frames: the last stretch is short
  EXPECT_EQ(kept[0], "frame0");
  EXPECT_EQ(std::count(kept.begin(), kept.end(), "frame30"), 1);  // the first of its place
  EXPECT_EQ(keptNames(1), kept);
  EXPECT_NE(keptNames(2), kept);
}

TEST(ThinnedRecording, HasTheCamerasOfTheRecording) {
  std::vector<Frame> frames = drawFrames(2, 12);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].camera = static_cast<int>(i % 2);
  const auto recording = thinOut(opener(frames, "two", {"/front", "/rear"})(), 2, 1);
  EXPECT_EQ(recording->cameras(), (std::vector<std::string>{"/front", "/rear"}));
}

}  // namespace
}  // namespace place_recognition
