#include "recognition/training/block_choice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_recognition {
namespace {

/// A feature of one bin, which the kernel |x - y|^2 treats as a point on a line.
CueOptions positionCue() {
  CueOptions cue;
  cue.kernel.type = "gaussian";
  return cue;
}

Feature at(double x, double y) {
  return DenseVector{{static_cast<float>(x), static_cast<float>(y)}};
}

struct Recording {
  std::vector<SampleOrigin> samples;
  std::vector<Feature> features;

  void add(int place, double stamp, Feature feature) {
    samples.push_back({place, 0, stamp});
    features.push_back(std::move(feature));
  }
  TimeBlocks blocks(const ValidationOptions& options = {}) const {
    return chooseBlocks(samples, {features}, {positionCue()}, options, 2).front();
  }
  LikenessOverTime likeness() const {
    return likenessOverTime(samples, 0, {features}, {positionCue()}, 2);
  }
};

/// Once around a circle in 40 s. With the chord's square as the distance, frames t seconds apart
/// differ by 1 - cos(2 pi t / 40) of the mean: an eighth after 3.2 s.
Recording circle(double rate) {
  constexpr double kPi = 3.14159265358979;
  Recording recording;
  for (int i = 0; i < static_cast<int>(40 * rate); ++i) {
    const double angle = 2 * kPi * i / (40 * rate);
    recording.add(0, 100 + i / rate, at(std::cos(angle), std::sin(angle)));
  }
  return recording;
}

TEST(BlockChoice, LikenessFallsAsTheCameraMoves) {
  const LikenessOverTime likeness = circle(5).likeness();
  EXPECT_NEAR(likeness.step, 0.2, 1e-9);
  EXPECT_GE(likeness.next_is_nearest, 0.99);     // the last frame is next to the first
  EXPECT_NEAR(likeness.distances[49], 1, 0.01);  // a quarter of the circle
  EXPECT_NEAR(likeness.distances[99], 2, 0.02);  // half of it
}

TEST(BlockChoice, GapIsAsLongAtAnyRateOfFrames) {
  for (const double rate : {2.0, 5.0, 30.0}) {
    const TimeBlocks blocks = circle(rate).blocks();
    EXPECT_NEAR(blocks.gap, 3.2, 1 / rate) << rate;
    EXPECT_EQ(blocks.length, blocks.gap);
  }
}

TEST(BlockChoice, GapIsAsLongHoweverManyFramesAreUsed) {
  for (const int every : {2, 3, 7}) {
    const Recording all = circle(30);
    Recording some;
    for (std::size_t i = 0; i < all.samples.size(); i += every) {
      some.add(0, all.samples[i].stamp, all.features[i]);
      if (i > 0) some.samples.back().skipped = every - 1;
    }
    EXPECT_NEAR(some.likeness().step, 1.0 / 30, 1e-9) << every;
    EXPECT_NEAR(some.blocks().gap, 3.2, every / 30.0) << every;
  }
  // Views 5 s apart are the most similar, but those used are 15 s apart: no view's successor is
  // used.
  Recording sparse;
  const Recording all = circle(0.2);
  for (const std::size_t i : {0u, 3u, 6u}) {
    sparse.add(0, all.samples[i].stamp, all.features[i]);
    if (i > 0) sparse.samples.back().skipped = 2;
  }
  EXPECT_DOUBLE_EQ(sparse.blocks().gap, 0.5 * 5);
}

TEST(BlockChoice, LooksAtEachCameraByItself) {
  const Recording alone = circle(5);
  Recording together = alone;
  for (std::size_t i = 0; i < alone.samples.size(); ++i) {
    together.add(0, alone.samples[i].stamp, alone.features[i]);
    together.samples.back().camera = 1;
  }
  EXPECT_NEAR(together.likeness().step, alone.likeness().step, 1e-9);
  EXPECT_NEAR(together.blocks().gap, alone.blocks().gap, 1e-9);
  EXPECT_NEAR(together.blocks().length, alone.blocks().length, 1e-9);
}

TEST(BlockChoice, LeavesTheNextImageOutIfItIsTheMostAlike) {
  const TimeBlocks blocks = circle(0.2).blocks();  // 5 s apart: more than an eighth of the mean
  EXPECT_DOUBLE_EQ(blocks.gap, 1.5 * 5);
}

TEST(BlockChoice, LeavesNoneOutIfTimeSaysNothingOfLikeness) {
  // A tripod: four directions per marker, each of which looks alike at all markers.
  Recording recording;
  for (int i = 0; i < 80; ++i) {
    const double direction = i % 4, marker = i / 4;
    recording.add(0, 0.2 * i, at(10 * direction, 0.1 * marker));
  }
  EXPECT_EQ(recording.likeness().next_is_nearest, 0);
  EXPECT_DOUBLE_EQ(recording.blocks().gap, 0.1);
}

TEST(BlockChoice, IsOverruledByOptions) {
  ValidationOptions options;
  options.gap = 7;
  EXPECT_EQ(circle(5).blocks(options).gap, 7);
  EXPECT_EQ(circle(5).blocks(options).length, 7);
  options.block = 9;
  EXPECT_EQ(circle(5).blocks(options).length, 9);
  options.gap = 0;
  EXPECT_EQ(circle(5).blocks(options).length, 9);
  EXPECT_NEAR(circle(5).blocks(options).gap, 3.2, 0.2);
  // A gap that is found leaves as much to train on as one that is given must.
  options.block = 2;
  EXPECT_EQ(circle(5).blocks(options).length, 2);
  EXPECT_NEAR(circle(5).blocks(options).gap, 2, 1e-9);
  options = {};
  options.folds = 2;
  options.gap = 0.5;
  EXPECT_NEAR(circle(5).blocks(options).length, 5, 1e-9);  // shorter: less than two fifths left
}

TEST(BlockChoice, CopesWithRoomsOfOneFrameAndFramesThatAreEqual) {
  Recording recording;
  recording.add(0, 1, at(0, 0));
  recording.add(1, 2, at(0, 0));
  EXPECT_GT(recording.blocks().length, 0);
  for (int i = 0; i < 10; ++i) recording.add(2, 3 + i, at(0, 0));
  EXPECT_GT(recording.blocks().length, 0);
}

}  // namespace
}  // namespace place_recognition
