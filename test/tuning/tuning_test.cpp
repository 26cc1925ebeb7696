#include "place_recognition/tuning.h"

#include <gtest/gtest.h>

#include "base/options.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

const std::vector<RecordingOpener> kNone;

/// A prior of one cue, which knows nothing of colour.
TrainingOptions greyCue() {
  TrainingOptions options = quickOptions();
  CrfhOptions brightness;
  brightness.descriptors = {"L"};
  brightness.scales = {4};
  brightness.bins = {8};
  options.cues[0].name = "brightness";
  options.cues[0].feature = brightness;
  return options;
}

SearchSpace smallSpace() {
  SearchSpace space;
  space.descriptors = {{"L"}, {"Lxx"}, {"R", "G", "B"}};
  space.scales = {{1}, {4}};
  space.bins = {4, 8};
  space.first_pictures = 10;
  space.max_pictures = 40;
  return space;
}

TEST(Tune, FindsWhatTrainTakes) {
  const std::vector<RecordingOpener> recordings{opener(drawFrames(3, 12))};
  const Tuning tuning = tune(recordings, kNone, greyCue(), smallSpace());
  EXPECT_TRUE(tuning.complete);
  EXPECT_EQ(tuning.images, 36u);
  tuning.options.check();
  EXPECT_NO_THROW(train(recordings, tuning.options));
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
    if (red) std::swap(channels[0], channels[2]);  // the grey image stays the same
    cv::merge(channels, frames[i].image);
  }
  SearchSpace space = smallSpace();
  space.other_light = false;
  const Tuning tuning = tune({opener(frames)}, kNone, greyCue(), space);
  ASSERT_EQ(tuning.options.cues.size(), 1u);
  EXPECT_EQ(tuning.options.cues[0].name.substr(0, 5), "R-G-B");
}

TEST(Tune, StaysWithThePriorWithoutGoodReason) {
  // Noise: no cue tells anything of the room.
  std::vector<Frame> frames = drawFrames(2, 20);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].image = drawRoom(0, static_cast<unsigned>(7 * i % 40));
  }
  const TrainingOptions prior = greyCue();
  const Tuning tuning = tune({opener(frames)}, kNone, prior, smallSpace());
  EXPECT_EQ(writeOptions(tuning.options), writeOptions(prior));
  EXPECT_GT(tuning.trials.size(), 1u);
}

TEST(Tune, DoesNotDependOnThreads) {
  const std::vector<RecordingOpener> recordings{opener(drawFrames(3, 9))};
  const Tuning one = tune(recordings, kNone, greyCue(), smallSpace(), 1);
  const Tuning three = tune(recordings, kNone, greyCue(), smallSpace(), 3);
  EXPECT_EQ(writeOptions(one.options), writeOptions(three.options));
  ASSERT_EQ(one.trials.size(), three.trials.size());
  for (std::size_t i = 0; i < one.trials.size(); ++i) {
    EXPECT_EQ(one.trials[i].log_loss, three.trials[i].log_loss);
  }
}

TEST(Tune, StoppedEarlyItGivesTheBestSoFar) {
  const std::vector<RecordingOpener> recordings{opener(drawFrames(3, 12))};
  for (const char* last : {"Comparing images", "Combining cues"}) {
    const Progress stop = [last](const std::string& stage, double) { return stage != last; };
    const Tuning tuning = tune(recordings, kNone, greyCue(), smallSpace(), 2, stop);
    EXPECT_FALSE(tuning.complete);
    EXPECT_EQ(writeOptions(tuning.options), writeOptions(greyCue()));
    EXPECT_EQ(tuning.best.images > 0, std::string(last) == "Combining cues");
  }
  const Progress stop_at_once = [](const std::string&, double) { return false; };
  EXPECT_THROW(tune(recordings, kNone, greyCue(), smallSpace(), 2, stop_at_once), Cancelled);
}

TEST(Tune, LaterRoundsLookAtMoreImagesAndFewerCandidates) {
  const Tuning tuning = tune({opener(drawFrames(2, 40))}, kNone, greyCue(), smallSpace());
  std::size_t first = 0;
  std::size_t second = 0;
  for (const TuningTrial& trial : tuning.trials) {
    if (trial.stage == "round 1 of 2") {
      ++first;
      EXPECT_LE(trial.images, 20u);
    }
    second += trial.stage == "round 2 of 2" ? 1 : 0;
  }
  EXPECT_EQ(first, 20u) << "two sets of colours each run and grey-world, one of derivatives";
  EXPECT_LT(second, first);
  EXPECT_EQ(tuning.trials.back().images, 40u);
}

}  // namespace
}  // namespace place_recognition
