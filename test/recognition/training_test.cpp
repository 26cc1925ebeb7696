#include "place_recognition/training.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// Returns the fraction of correct answers to new images of the drawn rooms.
double rateOn(Training training, int rooms) {
  Recognizer recognizer(std::make_shared<const Model>(std::move(training.model)));
  int right = 0;
  const std::vector<Frame> frames = drawFrames(rooms, 10, 500);
  for (const Frame& frame : frames) {
    const Recognition& answer = recognizer.recognize(frame.image);
    right += "room" + std::to_string(answer.place) == frame.place ? 1 : 0;
  }
  return right / static_cast<double>(frames.size());
}

TEST(Training, LearnsDrawnRooms) {
  Training training = train({opener(drawFrames(4, 20))}, quickOptions());
  EXPECT_EQ(training.images, 80u);
  ASSERT_EQ(training.warnings.size(), 1u);
  EXPECT_EQ(training.warnings[0].find("'room2' and 'room3' look alike"), 0u)
      << training.warnings[0];
  EXPECT_GT(training.model.validation.average_rate, 0.7);
  EXPECT_LT(training.model.validation.calibration_error, 0.2);
  EXPECT_GT(training.model.options.cues[0].kernel.gamma, 0);
  EXPECT_GT(rateOn(std::move(training), 4), 0.7);
}

TEST(Training, CombinesCuesAndRuns) {
  Training training =
      train({opener(drawFrames(3, 10), "a"), opener(drawFrames(3, 10, 100), "b")}, twoCueOptions());
  ASSERT_EQ(training.model.cue_weights.size(), 2u);
  EXPECT_DOUBLE_EQ(training.model.cue_weights[0] + training.model.cue_weights[1], 1);
  EXPECT_EQ(training.model.provenance.inputs, (std::vector<std::string>{"a", "b"}));
  EXPECT_GT(rateOn(std::move(training), 3), 0.9);
}

TEST(Training, ReducesTheModel) {
  TrainingOptions options = quickOptions();
  options.reduction.method = "none";
  const std::size_t all = train({opener(drawFrames(3, 20))}, options).model.supportVectorCount();
  options.reduction.method = "shared-greedy";
  options.reduction.support_vectors = 9;
  Training reduced = train({opener(drawFrames(3, 20))}, options);
  EXPECT_LT(reduced.model.supportVectorCount(), all);
  EXPECT_LE(reduced.model.supportVectorCount(), 9u);
  EXPECT_GT(rateOn(std::move(reduced), 3), 0.8);
}

TEST(Training, LearnsThePartsOfARecordingLikeTheWhole) {
  std::vector<Frame> whole;
  for (const unsigned first_frame : {0u, 100u}) {
    for (Frame frame : drawFrames(3, 20, first_frame)) {
      frame.stamp = static_cast<double>(whole.size());
      whole.push_back(frame);
    }
  }
  const auto bytes = [](const std::vector<RecordingOpener>& recordings, std::size_t inputs) {
    Model model = train(recordings, quickOptions()).model;
    EXPECT_EQ(model.provenance.inputs.size(), inputs);
    EXPECT_TRUE(model.adjacency.joined(0, 1));
    model.provenance.inputs.clear();
    model.provenance.sketches.clear();
    return serializeModel(model);
  };
  EXPECT_EQ(bytes(openersOfParts(whole, {20, 50, 80}), 4), bytes({opener(whole)}, 1));
}

TEST(Training, GivesTheSameBytesWhateverTheThreads) {
  const std::vector<RecordingOpener> recordings{opener(drawFrames(3, 9))};
  const std::string once = serializeModel(train(recordings, twoCueOptions(), 1).model);
  EXPECT_EQ(serializeModel(train(recordings, twoCueOptions(), 1).model), once);
  EXPECT_EQ(serializeModel(train(recordings, twoCueOptions(), 2).model), once);
  EXPECT_EQ(serializeModel(train(recordings, twoCueOptions(), 5).model), once);
}

/// Returns the same frames from a camera with `factor` times the size.
std::vector<Frame> resized(std::vector<Frame> frames, double factor) {
  for (Frame& frame : frames) {
    cv::resize(frame.image, frame.image, {}, factor, factor, cv::INTER_AREA);
  }
  return frames;
}

TEST(Training, RunsOfDifferentSizesAreLearnedAtTheSmallest) {
  const std::vector<RecordingOpener> recordings{
      opener(resized(drawFrames(3, 12), 4), "large"), opener(drawFrames(3, 12, 100), "small"),
      opener(resized(drawFrames(3, 12, 200), 2), "middle")};
  const Training training = train(recordings, quickOptions());
  EXPECT_EQ(training.model.images.width, 96);
  EXPECT_EQ(training.model.images.height, 72);
  ASSERT_EQ(training.warnings.size(), 2u);
  EXPECT_EQ(training.warnings[0].substr(0, 24), "large: Images of 384 x 2");
  EXPECT_EQ(training.warnings[1].substr(0, 24), "middle: Images of 192 x ");
  EXPECT_EQ(serializeModel(train(recordings, quickOptions(), 3).model),
            serializeModel(training.model));

  EXPECT_GT(rateOn(train(recordings, quickOptions()), 3), 0.8);
}

TEST(Training, LearnsOnAtTheSizeOfTheModel) {
  const Training before = train({opener(drawFrames(3, 12), "monday")}, quickOptions());
  const std::vector<Frame> same = drawFrames(3, 12, 100);
  Training after = trainIncrementally(before.model, {opener(resized(same, 2), "tuesday")}, {0});
  EXPECT_EQ(after.model.images.width, 96);
  ASSERT_FALSE(after.warnings.empty());
  EXPECT_NE(after.warnings.back().find("192 x 144 are scaled to 96 x 72"), std::string::npos);
  EXPECT_GT(rateOn(std::move(after), 3), 0.8);
}

TEST(Training, StopsWhenAsked) {
  for (const char* stage : {"Reading drawn", "Choosing gamma", "Training", "Calibrating"}) {
    const auto progress = [stage](const std::string& now, double) { return now != stage; };
    EXPECT_THROW(train({opener(drawFrames(2, 6))}, quickOptions(), 2, progress), Cancelled)
        << stage;
  }
}

TEST(Training, ReportsRisingFractions) {
  std::string last_stage;
  double last = 0;
  train({opener(drawFrames(2, 6))}, quickOptions(), 2,
        [&](const std::string& stage, double fraction) {
          EXPECT_TRUE(stage != last_stage || fraction >= last) << stage;
          EXPECT_GE(fraction, 0);
          EXPECT_LE(fraction, 1);
          last_stage = stage;
          last = fraction;
          return true;
        });
}

/// Returns frames of three rooms in sequence, followed by the first room again if `returns`.
std::vector<Frame> driveOf(bool returns) {
  std::vector<Frame> frames = drawFrames(3, 20);
  if (returns) {
    for (const Frame& frame : drawFrames(1, 20, 20)) {
      frames.push_back(frame);
      frames.back().stamp += 60;
    }
  }
  return frames;
}

TEST(Training, LearnsFromADriveWhichRoomsAdjoin) {
  const Adjacency learned = train({opener(driveOf(true))}, quickOptions()).model.adjacency;
  ASSERT_EQ(learned.places(), 3u);
  EXPECT_TRUE(learned.joined(0, 1) && learned.joined(1, 2) && learned.joined(2, 0));

  // Unlabelled frames while passing a door are part of the drive.
  std::vector<Frame> frames = driveOf(true);
  frames[19].place = frames[20].place = "";
  for (std::size_t i = 40; i < frames.size(); ++i) frames[i].stamp += 10;  // after room1
  const Adjacency gaps = train({opener(frames)}, quickOptions()).model.adjacency;
  EXPECT_TRUE(gaps.joined(0, 1));
  EXPECT_FALSE(gaps.joined(1, 2));  // the time between them is too long

  const Adjacency sorted = train({opener(driveOf(false))}, quickOptions()).model.adjacency;
  EXPECT_TRUE(sorted.empty());
}

TEST(Training, SaysThatNothingWasValidated) {
  const Training training = train({opener(drawFrames(2, 1))}, quickOptions());
  EXPECT_TRUE(training.model.validatedPlaces().empty());
  EXPECT_EQ(train({opener(drawFrames(2, 12))}, quickOptions()).model.validatedPlaces(),
            (std::vector<std::string>{"room0", "room1"}));
}

TEST(Training, NamesPlacesThatLookAlike) {
  std::vector<Frame> frames = drawFrames(2, 40);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].place == "room0") frames[i].place = i % 2 == 0 ? "east" : "west";
  }
  const std::vector<std::string> warnings = train({opener(frames)}, quickOptions()).warnings;
  const auto alike = [](const std::string& text) {
    return text.find("'east' and 'west' look alike") == 0;
  };
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), alike), 1);
  for (const std::string& warning : train({opener(drawFrames(3, 40))}, quickOptions()).warnings) {
    EXPECT_EQ(warning.find("look alike"), std::string::npos) << warning;
  }
}

}  // namespace
}  // namespace place_recognition
