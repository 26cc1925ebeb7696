#include "recognition/training/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/training.h"
#include "recognition/drawn_recording.h"
#include "recognition/training/calibration_set.h"
#include "recognition/training/halving_sample.h"
#include "recognition/training/samples.h"

namespace place_recognition {
namespace {

std::size_t admitted(double rate, double fps, int count) {
  FrameRate frame_rate(rate);
  std::size_t result = 0;
  for (int i = 0; i < count; ++i) result += frame_rate.admits(1000 + i / fps) ? 1 : 0;
  return result;
}

TEST(FrameRate, ThinsOutToANumberPerSecond) {
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

using Counts = std::vector<std::size_t>;

TEST(EqualShares, AreAllMembersIfThereAreFew) {
  EXPECT_EQ(equalShares({5, 5}, 10), Counts({5, 5}));
  EXPECT_EQ(equalShares({}, 10), Counts());
}

TEST(EqualShares, AreRoundedByTheLargestRemainder) {
  EXPECT_EQ(equalShares({5, 5}, 5), Counts({3, 2}));
  EXPECT_EQ(equalShares({900, 90, 10}, 100), Counts({90, 9, 1}));
  // Exact: 3.6, 3.3, 3.1.
  EXPECT_EQ(equalShares({36, 33, 31}, 10), Counts({4, 3, 3}));
}

TEST(EqualShares, HaveOneOfEveryGroupAtTheCostOfTheMostFavoured) {
  // Exact: 9.7, 0.2, 0.1.
  EXPECT_EQ(equalShares({970, 20, 10}, 10), Counts({8, 1, 1}));
  // Exact: 4.4, 5.5, 0.1; rounded down and with one of the last: 4, 5, 1.
  EXPECT_EQ(equalShares({440, 550, 10}, 10), Counts({4, 5, 1}));
  // Exact: 3.2, 3.5, 0.1, 0.1, 0.1.
  EXPECT_EQ(equalShares({320, 350, 10, 10, 10}, 7), Counts({2, 2, 1, 1, 1}));
  EXPECT_EQ(equalShares({50, 1, 1, 0}, 2), Counts({1, 1, 1, 0}));
}

TEST(EqualShares, AreNoMoreThanTheMostInTotal) {
  const Counts sizes{231, 252, 249, 341, 458, 1, 0};
  for (std::size_t most = 6; most <= 1532; ++most) {
    const Counts shares = equalShares(sizes, most);
    EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), std::size_t{0}), most);
    for (std::size_t k = 0; k < sizes.size(); ++k) EXPECT_LE(shares[k], sizes[k]) << most;
  }
}

TEST(StratifiedSample, DrawsOneFromEachStretchOfEachGroup) {
  std::vector<int> groups(900, 0);
  groups.insert(groups.end(), 90, 1);
  groups.insert(groups.end(), 10, 2);
  const std::vector<bool> kept = stratifiedSample(groups, 100, 1);
  const auto count = [&](int from, int to) {
    return std::count(kept.begin() + from, kept.begin() + to, true);
  };
  EXPECT_EQ(count(0, 900), 90);
  EXPECT_EQ(count(900, 990), 9);
  EXPECT_EQ(count(990, 1000), 1);
  for (int i = 0; i + 10 <= 900; i += 10) EXPECT_EQ(count(i, i + 10), 1) << i;
}

TEST(StratifiedSample, KeepsSomethingOfEveryGroupAndAllWhereThereAreFew) {
  const std::vector<bool> kept = stratifiedSample({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2}, 2, 1);
  EXPECT_EQ(std::count(kept.begin(), kept.begin() + 9, true), 1);
  EXPECT_TRUE(kept[9] && kept[10]);
  const std::vector<bool> all = stratifiedSample({0, 1, 1}, 3, 1);
  EXPECT_EQ(std::count(all.begin(), all.end(), true), 3);
  EXPECT_TRUE(stratifiedSample({}, 5, 1).empty());
}

/// Counts the `kept` samples at each of the twelve angles of a tripod that turns at every marker.
std::array<int, 12> angles(const std::vector<bool>& kept) {
  std::array<int, 12> count{};
  for (std::size_t i = 0; i < kept.size(); ++i) count[i % 12] += kept[i] ? 1 : 0;
  return count;
}

TEST(StratifiedSample, SeesEveryAngleOfATripod) {
  // A fixed step of 6 or 12 would see only two angles or one.
  const std::vector<int> one_room(1200, 0);
  for (const std::size_t most : {200u, 100u}) {
    for (const int count : angles(stratifiedSample(one_room, most, 1))) EXPECT_GT(count, 0) << most;
  }
  EXPECT_EQ(stratifiedSample(one_room, 100, 1), stratifiedSample(one_room, 100, 1));
  EXPECT_NE(stratifiedSample(one_room, 100, 1), stratifiedSample(one_room, 100, 2));
}

TEST(HeldOutFrames, AreNoMoreThanAModelKeeps) {
  // Fractions that do not divide 1000.
  const std::vector<int> rooms{231, 252, 249, 341, 458};
  CalibrationSet calibration_set;
  for (std::size_t k = 0; k < rooms.size(); ++k) {
    for (int i = 0; i < rooms[k]; ++i)
      calibration_set.samples.push_back({static_cast<int>(k), 0, 1.0 * i});
  }
  const auto count = static_cast<Eigen::Index>(calibration_set.samples.size());
  calibration_set.reductions = {{HeldOutValues{
      Eigen::MatrixXd::Zero(count, 5), std::vector<bool>(calibration_set.samples.size(), true),
      Eigen::VectorXd::Zero(count)}}};
  calibration_set.judges_unknown.assign(calibration_set.samples.size(), true);
  const HeldOutFrames kept = keptFrames(calibration_set, 0, 1);
  EXPECT_EQ(kept.places.size(), kMaxHeldOutFrames);
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(std::count(kept.places.begin(), kept.places.end(), k),
                1000.0 * rooms[static_cast<std::size_t>(k)] / static_cast<double>(count), 1);
  }
}

TEST(StratifiedStream, KeepsTheFirstAndOneOfEachStretch) {
  StratifiedStream stream(12, 1);
  std::vector<bool> kept;
  for (int i = 0; i < 1200; ++i) kept.push_back(stream.keepsNext());
  EXPECT_TRUE(kept[0]);
  for (auto stretch = kept.begin(); stretch != kept.end(); stretch += 12) {
    EXPECT_EQ(std::count(stretch, stretch + 12, true), 1);
  }
  for (const int count : angles(kept)) EXPECT_GT(count, 0);

  StratifiedStream all(1, 1);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(all.keepsNext());
}

TEST(StratifiedLevels, EveryStretchOfAPowerOfTwoHasOneMemberOfThatLevel) {
  StratifiedLevels stream(1), same(1), other(2);
  std::vector<int> levels, others;
  for (int i = 0; i < 4096; ++i) {
    levels.push_back(stream.next());
    EXPECT_EQ(levels.back(), same.next());
    others.push_back(other.next());
  }
  EXPECT_NE(levels, others);
  for (int k = 0, length = 1; length <= 4096; ++k, length *= 2) {
    const auto isHigh = [k](int level) { return level >= k; };
    for (auto stretch = levels.begin(); stretch != levels.end(); stretch += length) {
      EXPECT_EQ(std::count_if(stretch, stretch + length, isHigh), 1) << k;
    }
  }
  EXPECT_GE(levels[0], 12);
}

TEST(StratifiedLevels, SeeEveryAngleOfATripod) {
  StratifiedLevels stream(1);
  std::vector<bool> kept;
  for (int i = 0; i < 2400; ++i) kept.push_back(stream.next() >= 4);
  for (const int count : angles(kept)) EXPECT_GT(count, 0);
}

/// A hundred frames of each of two rooms, at 20 Hz.
Training trainFast(const TrainingOptions& options) {
  std::vector<Frame> frames = drawFrames(2, 100);
  for (Frame& frame : frames) frame.stamp /= 20;
  return train({opener(frames, "fast.bag")}, options);
}

TEST(Sampling, LearnsAllFramesOrANumberPerSecond) {
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
  EXPECT_EQ(trainFast(options).images, 20u);  // and as many in other light
}

TEST(Sampling, LooksAtFewerAndFewerImagesOfALongRun) {
  const std::vector<Frame> frames = drawFrames(2, 400);
  TrainingOptions options = quickOptions();
  options.sampling.most = 40;  // 20, and 20 changed copies
  int looked_at = 0;
  const auto change = [&](const cv::Mat& image, const std::string&) {
    ++looked_at;
    return ChangedImage{image, {}};
  };
  const Samples samples = collectSamples({opener(frames)}, options, 2, {}, 2, {}, change);
  EXPECT_EQ(samples.recorded, 20u);
  EXPECT_EQ(samples.images, (std::vector<std::uint64_t>{10, 10}));
  EXPECT_EQ(samples.passed_over, 780u);
  // 40 until frames are dropped for the first time, 20 between any two times.
  EXPECT_LE(looked_at, 40 + 20 * 6);
  ASSERT_EQ(samples.warnings.size(), 1u);
  EXPECT_NE(samples.warnings[0].find("Of 800 images 20 are learned"), std::string::npos)
      << samples.warnings[0];
  std::array<int, 4> quarters{};  // of each room, in the order of its frames
  for (std::size_t i = 0; i < samples.recorded; ++i) {
    const auto quarter = static_cast<std::size_t>(samples.origins[i].stamp / 200);
    ++quarters.at(quarter);
  }
  for (const int count : quarters) EXPECT_NEAR(count, 5, 2);
}

TEST(Sampling, OfALongRunTheSameImagesAreLearnedWhateverTheThreads) {
  TrainingOptions options = quickOptions();
  options.sampling.most = 30;
  const auto stamps = [&](unsigned threads) {
    const Samples samples = collectSamples({opener(drawFrames(2, 200))}, options, threads, {});
    std::vector<double> stamps;
    for (const SampleOrigin& origin : samples.origins) stamps.push_back(origin.stamp);
    return stamps;
  };
  const std::vector<double> one = stamps(1);
  EXPECT_EQ(one.size(), 30u);
  EXPECT_EQ(stamps(4), one);
}

TEST(Sampling, FramesThatAreNotLearnedCountAsSkipped) {
  TrainingOptions options = quickOptions();
  options.sampling.most = 30;
  const std::vector<Frame> frames = drawFrames(2, 200);
  const Samples samples = collectSamples({opener(frames)}, options, 2, {});
  std::map<std::string, std::vector<double>> stamps;
  for (const Frame& frame : frames) stamps[frame.place].push_back(frame.stamp);
  std::map<std::string, std::size_t> next;
  for (const SampleOrigin& origin : samples.origins) {
    const std::string& place = samples.places[static_cast<std::size_t>(origin.place)];
    next[place] += static_cast<std::size_t>(origin.skipped);
    EXPECT_EQ(stamps[place].at(next[place]++), origin.stamp) << place;
  }
  EXPECT_EQ(next.size(), 2u);
}

TEST(Sampling, VectorsOfBothModelsLeaveRoomForFewerNewImagesOnce) {
  TrainingOptions options = quickOptions();
  options.reduction.method = "none";
  options.sampling.most = 1200;
  const Model model = train({opener(drawFrames(4, 30))}, options).model;
  const Model other = train({opener(drawFrames(4, 30, 100))}, options).model;
  IncrementalOptions incremental;
  incremental.other = &other;
  const Training training =
      trainIncrementally(model, {opener(drawFrames(2, 600, 200))}, incremental);
  const std::size_t vectors = model.supportVectorCount() + other.supportVectorCount();
  EXPECT_NEAR(static_cast<double>(training.images), 1200 - static_cast<double>(vectors), 2);
  EXPECT_EQ(training.model.options.sampling.most, 1200);  // calibrate and reduce read them all
}

TEST(Sampling, TheSeedSaysWhichImagesAreLearned) {
  TrainingOptions options = quickOptions();
  options.sampling.most = 40;
  const std::string model = serializeModel(trainFast(options).model);
  EXPECT_EQ(serializeModel(trainFast(options).model), model);
  options.seed = 2;
  Model other = trainFast(options).model;
  other.options.seed = 1;
  EXPECT_NE(serializeModel(other), model);
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
