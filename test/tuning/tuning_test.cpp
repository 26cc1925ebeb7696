#include "place_recognition/tuning.h"

#include <gtest/gtest.h>

#include "base/options.h"
#include "recognition/drawn_run.h"

namespace place_recognition {
namespace {

const std::vector<RunOpener> kNone;

TrainingOptions withoutCues() {
  TrainingOptions options;
  options.cues.clear();
  return options;
}

SearchSpace smallSpace() {
  SearchSpace space;
  space.descriptors = {{"L"}, {"Lxx"}, {"R", "G", "B"}};
  space.scales = {{1}, {4}};
  space.bins = {4, 8};
  space.gamma_factors = {0.5, 1, 2};
  space.first_pictures = 10;
  space.max_pictures = 40;
  return space;
}

TEST(Tune, FindsWhatTrainTakes) {
  const std::vector<RunOpener> runs{opener(drawFrames(3, 12))};
  const Tuning tuning = tune(runs, kNone, withoutCues(), smallSpace());
  EXPECT_TRUE(tuning.complete);
  EXPECT_EQ(tuning.pictures, 36u);
  tuning.options.check();
  EXPECT_EQ(tuning.options.reduction.method, "none") << "nothing else was judged";
  EXPECT_NO_THROW(train(runs, tuning.options));
  EXPECT_GT(tuning.best.rate, 0.9) << "drawn rooms are easily told apart";
  for (const TuningTrial& trial : tuning.trials) {
    EXPECT_GE(trial.log_loss, 0);
    EXPECT_LE(trial.rate, 1);
  }
}

TEST(Tune, ColourIsChosenWhereOnlyColourTells) {
  std::vector<Frame> frames = drawFrames(2, 12);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool red = frames[i].place == "room0";
    frames[i].image = drawRoom(0, static_cast<unsigned>(i));
    std::vector<cv::Mat> channels;
    cv::split(frames[i].image, channels);
    if (red) std::swap(channels[0], channels[2]);  // the grey picture stays the same
    cv::merge(channels, frames[i].image);
  }
  SearchSpace space = smallSpace();
  space.other_light = false;
  const Tuning tuning = tune({opener(frames)}, kNone, withoutCues(), space);
  EXPECT_EQ(tuning.options.cues.front().name.substr(0, 5), "R-G-B");
}

TEST(Tune, DoesNotDependOnThreads) {
  const std::vector<RunOpener> runs{opener(drawFrames(3, 9))};
  const Tuning one = tune(runs, kNone, withoutCues(), smallSpace(), 1);
  const Tuning three = tune(runs, kNone, withoutCues(), smallSpace(), 3);
  EXPECT_EQ(writeOptions(one.options), writeOptions(three.options));
  ASSERT_EQ(one.trials.size(), three.trials.size());
  for (std::size_t i = 0; i < one.trials.size(); ++i) {
    EXPECT_EQ(one.trials[i].log_loss, three.trials[i].log_loss);
  }
}

TEST(Tune, StoppedEarlyItGivesTheBestSoFar) {
  const std::vector<RunOpener> runs{opener(drawFrames(3, 12))};
  const Progress stop_at_cues = [](const std::string& stage, double) {
    return stage != "Combining cues";
  };
  const Tuning tuning = tune(runs, kNone, withoutCues(), smallSpace(), 2, stop_at_cues);
  EXPECT_FALSE(tuning.complete);
  EXPECT_EQ(tuning.options.cues.size(), 1u);
  const Progress stop_at_once = [](const std::string&, double) { return false; };
  EXPECT_THROW(tune(runs, kNone, withoutCues(), smallSpace(), 2, stop_at_once), Cancelled);
}

TEST(Tune, LaterRoundsLookAtMorePicturesAndFewerCandidates) {
  const Tuning tuning = tune({opener(drawFrames(2, 40))}, kNone, withoutCues(), smallSpace());
  std::size_t first = 0;
  std::size_t second = 0;
  for (const TuningTrial& trial : tuning.trials) {
    if (trial.stage == "round 1 of 2") {
      ++first;
      EXPECT_LE(trial.pictures, 20u);
    }
    second += trial.stage == "round 2 of 2" ? 1 : 0;
  }
  EXPECT_EQ(first, 12u);
  EXPECT_LT(second, first);
  EXPECT_EQ(tuning.trials.back().pictures, 40u);
}

}  // namespace
}  // namespace place_recognition
