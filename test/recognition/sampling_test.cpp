#include "recognition/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "place_recognition/error.h"
#include "place_recognition/training.h"
#include "recognition/drawn_run.h"

namespace place_recognition {
namespace {

std::size_t admitted(double rate, double fps, int count) {
  FrameRate frame_rate(rate);
  std::size_t result = 0;
  for (int i = 0; i < count; ++i) result += frame_rate.admits(1000 + i / fps) ? 1 : 0;
  return result;
}

TEST(FrameRate, ThinsOutToSoManyASecond) {
  EXPECT_NEAR(admitted(5, 30, 300), 50, 1);
  EXPECT_EQ(admitted(5, 5, 300), 300u);
  EXPECT_EQ(admitted(5, 1, 300), 300u);
  EXPECT_EQ(admitted(0, 30, 300), 300u);
}

TEST(FrameRate, TakesAllWhereStampsTellNothing) {
  FrameRate standing(5), backwards(5);
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(standing.admits(0));
    EXPECT_TRUE(backwards.admits(-i));
  }
}

TEST(EvenShare, TakesTheSameShareOfEachGroupEvenly) {
  std::vector<int> groups(900, 0);
  groups.insert(groups.end(), 90, 1);
  groups.insert(groups.end(), 10, 2);
  const std::vector<bool> kept = evenShare(groups, 100);
  const auto count = [&](int from, int to) {
    return std::count(kept.begin() + from, kept.begin() + to, true);
  };
  EXPECT_EQ(count(0, 900), 90);
  EXPECT_EQ(count(900, 990), 9);
  EXPECT_EQ(count(990, 1000), 1);
  for (int i = 0; i + 10 <= 900; ++i) EXPECT_EQ(count(i, i + 10), 1) << i;
}

TEST(EvenShare, KeepsSomethingOfEveryGroupAndAllWhereThereAreFew) {
  const std::vector<bool> kept = evenShare({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2}, 2);
  EXPECT_TRUE(kept[0] && kept[9] && kept[10]);
  const std::vector<bool> all = evenShare({0, 1, 1}, 3);
  EXPECT_EQ(std::count(all.begin(), all.end(), true), 3);
  EXPECT_TRUE(evenShare({}, 5).empty());
}

/// A hundred frames of each of two rooms, 20 a second.
Training trainFast(const TrainingOptions& options) {
  std::vector<Frame> frames = drawFrames(2, 100);
  for (Frame& frame : frames) frame.stamp /= 20;
  return train({opener(frames, "fast.bag")}, options);
}

TEST(Sampling, LearnsAllFramesOrSoManyASecond) {
  EXPECT_EQ(trainFast(quickOptions()).images, 200u);
  TrainingOptions options = quickOptions();
  options.sampling.rate = 5;
  const Training training = trainFast(options);
  EXPECT_NEAR(static_cast<double>(training.images), 50, 1);
  EXPECT_EQ(training.images + training.passed_over, 200u);
  EXPECT_TRUE(training.warnings.empty()) << training.warnings[0];
}

TEST(Sampling, LearnsNoMoreThanItMayAndSaysSo) {
  TrainingOptions options = quickOptions();
  options.sampling.most = 40;
  const Training training = trainFast(options);
  EXPECT_EQ(training.images, 40u);
  EXPECT_EQ(training.passed_over, 160u);
  EXPECT_EQ(training.model.provenance.place_images, (std::vector<std::uint64_t>{20, 20}));
  ASSERT_EQ(training.warnings.size(), 1u);
  EXPECT_NE(training.warnings[0].find("sampling.most"), std::string::npos);

  options.augmentation.other_light = true;
  EXPECT_EQ(trainFast(options).images, 20u);  // and the same in other light
}

TEST(Sampling, OptionsOutOfRangeAreRefused) {
  TrainingOptions options = quickOptions();
  options.sampling.rate = -1;
  EXPECT_THROW(options.check(), Error);
  options.sampling = {};
  options.sampling.most = 1;
  EXPECT_THROW(options.check(), Error);
}

}  // namespace
}  // namespace place_recognition
