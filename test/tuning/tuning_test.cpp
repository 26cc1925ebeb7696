#include "place_recognition/tuning.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "base/options.h"
#include "recognition/drawn_recording.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

const std::vector<RecordingOpener> kNone;

/// A prior with a single cue, which ignores colour.
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

void expectSame(const Tuning& a, const Tuning& b) {
  EXPECT_EQ(writeOptions(a.options), writeOptions(b.options));
  ASSERT_EQ(a.trials.size(), b.trials.size());
  for (std::size_t i = 0; i < a.trials.size(); ++i) {
    EXPECT_EQ(a.trials[i].stage, b.trials[i].stage);
    EXPECT_EQ(a.trials[i].cues.front().name, b.trials[i].cues.front().name);
    EXPECT_EQ(a.trials[i].c, b.trials[i].c);
    EXPECT_EQ(a.trials[i].images, b.trials[i].images);
    EXPECT_EQ(a.trials[i].log_loss, b.trials[i].log_loss);
    EXPECT_EQ(a.trials[i].rate, b.trials[i].rate);
    EXPECT_EQ(a.trials[i].changed_rate, b.trials[i].changed_rate);
  }
}

std::size_t filesIn(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                std::filesystem::directory_iterator()));
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

TEST(Tune, KeepsThePriorUnlessThereIsGoodReason) {
  // Noise: no cue contains information about the room.
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
  expectSame(one, three);
}

TEST(Tune, PartsComputeAllCellsOfTheWhole) {
  const ScratchFolder scratch;
  const std::string cells = scratch / "cells";
  const std::vector<RecordingOpener> recordings{opener(drawFrames(2, 40))};
  for (const int number : {2, 3, 1}) {
    const TuningPart part =
        tunePart(recordings, kNone, greyCue(), smallSpace(), cells, {number, 3});
    EXPECT_EQ(part.cells, number == 2 ? 1u : 2u) << "a round leaves one cue of Lxx's four";
    EXPECT_EQ(part.computed, part.cells);
  }
  EXPECT_EQ(filesIn(cells), 5u);
  EXPECT_EQ(tunePart(recordings, kNone, greyCue(), smallSpace(), cells, {4, 4}).cells, 0u);
  const Tuning whole = tune(recordings, kNone, greyCue(), smallSpace());
  expectSame(tune(recordings, kNone, greyCue(), smallSpace(), 0, {}, cells), whole);
  EXPECT_EQ(filesIn(cells), 5u);
}

TEST(Tune, RefusesPartsThatDoNotExist) {
  const std::vector<RecordingOpener> recordings{opener(drawFrames(2, 4))};
  for (const Part& part : {Part{1, 0}, Part{0, 3}, Part{4, 3}}) {
    EXPECT_THROW(tunePart(recordings, kNone, greyCue(), smallSpace(), "cells", part), Error);
  }
  EXPECT_THROW(tunePart(recordings, kNone, greyCue(), smallSpace(), "", {}), Error);
}

TEST(Tune, ContinuesWhereItStopped) {
  const ScratchFolder scratch;
  const std::string cells = scratch / "cells";
  const std::vector<RecordingOpener> recordings{opener(drawFrames(2, 40))};
  const Progress stop = [](const std::string& stage, double fraction) {
    return stage != "Looking for cues, round 2 of 2" || fraction < 0.5;
  };
  EXPECT_FALSE(tune(recordings, kNone, greyCue(), smallSpace(), 0, stop, cells).complete);
  EXPECT_EQ(filesIn(cells), 4u);
  EXPECT_EQ(tunePart(recordings, kNone, greyCue(), smallSpace(), cells, {}).computed, 1u);
  expectSame(tune(recordings, kNone, greyCue(), smallSpace(), 0, {}, cells),
             tune(recordings, kNone, greyCue(), smallSpace()));
}

TEST(Tune, UsesOnlyCellsOfTheSameImagesAndOptions) {
  const ScratchFolder scratch;
  const std::vector<Frame> frames = drawFrames(2, 8);
  const auto computed = [&](const std::vector<Frame>& shown, const TrainingOptions& base,
                            const SearchSpace& space, const std::string& name = "drawn") {
    const TuningPart part =
        tunePart({opener(shown, name)}, kNone, base, space, scratch / "cells", {});
    return part.computed;
  };
  EXPECT_EQ(computed(frames, greyCue(), smallSpace()), 3u);

  const std::vector<std::function<void(std::vector<Frame>&)>> changes{
      [](std::vector<Frame>& shown) { shown[3].image.at<cv::Vec3b>(5, 7)[1] ^= 1; },
      [](std::vector<Frame>& shown) { shown[3].place = "room1"; },
      [](std::vector<Frame>& shown) { shown[3].stamp += 0.25; },
      [](std::vector<Frame>& shown) { shown.pop_back(); }};
  for (const auto& change : changes) {
    std::vector<Frame> changed = drawFrames(2, 8);
    change(changed);
    EXPECT_EQ(computed(changed, greyCue(), smallSpace()), 3u);
  }
  TrainingOptions other_c = greyCue();
  other_c.svm.c *= 2;
  EXPECT_EQ(computed(frames, other_c, smallSpace()), 3u);
  SearchSpace same_light = smallSpace();
  same_light.other_light = false;
  EXPECT_EQ(computed(frames, greyCue(), same_light), 3u);

  EXPECT_EQ(computed(frames, quickOptions(), smallSpace()), 0u)
      << "the cues of the base take no part in the rounds";
  EXPECT_EQ(computed(frames, greyCue(), smallSpace(), "elsewhere"), 0u);
}

TEST(Tune, GivesTheBestSoFarWhenStoppedEarly) {
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
