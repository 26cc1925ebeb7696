// What learning on does to the room that is added, to the other rooms, and to "unknown".
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// The fractions of new frames of some rooms that are answered correctly and 'unknown'.
struct Fractions {
  double right = 0;
  double unknown = 0;
};
Fractions fractionsOf(const std::shared_ptr<const Model>& model, const std::vector<Frame>& frames) {
  Recognizer recognizer(model);
  Fractions fractions;
  const double part = 1 / static_cast<double>(frames.size());
  for (const Frame& frame : frames) {
    const Recognition& answer = recognizer.recognize(frame.image);
    if (model->places[static_cast<std::size_t>(answer.place)] == frame.place)
      fractions.right += part;
    if (!answer.known) fractions.unknown += part;
  }
  return fractions;
}

/// Trains on three drawn rooms, adds `frames`, and compares the answers to the first two rooms.
void expectOthersAsTheyWere(const std::vector<Frame>& frames, const TrainingOptions& options) {
  const auto before =
      std::make_shared<const Model>(train({opener(drawFrames(3, 30))}, options).model);
  const auto after =
      std::make_shared<const Model>(trainIncrementally(*before, {opener(frames)}, {0}).model);
  const std::vector<Frame> others = drawFrames(2, 50, 5000);
  EXPECT_NEAR(fractionsOf(after, others).right, fractionsOf(before, others).right, 0.02);
  EXPECT_NEAR(fractionsOf(after, others).unknown, fractionsOf(before, others).unknown, 0.02);
  for (const std::string& place : before->places) {
    const std::vector<std::string> judged = after->validatedPlaces();
    EXPECT_EQ(std::count(judged.begin(), judged.end(), place), 1) << place;
  }
}

TEST(TrainIncrementally, WithinALimitKeepsTheWeightsOfCuesAndWhatIsUnknown) {
  const auto before =
      std::make_shared<const Model>(train({opener(drawFrames(3, 60))}, twoCueOptions()).model);
  Model model = train({opener(drawFrames(3, 60))}, twoCueOptions()).model;
  for (unsigned night = 1; night <= 5; ++night) {
    std::vector<Frame> frames = drawFrames(3, 3, 1000 * night);
    for (Frame& frame : frames) frame.image = frame.image * (0.5 + 0.1 * night);
    model = trainIncrementally(model, {opener(frames)}, {60}).model;
  }
  EXPECT_EQ(model.cue_weights, before->cue_weights);
  const auto after = std::make_shared<const Model>(std::move(model));
  const std::vector<Frame> strange = framesOf("room3", 7000, 50);
  EXPECT_GE(fractionsOf(after, strange).unknown, fractionsOf(before, strange).unknown);
}

TEST(TrainIncrementally, ANewRoomIsRecognizedAsIfLearnedWithTheOthers) {
  std::vector<Frame> others;
  for (const Frame& frame : drawFrames(4, 30)) {
    if (frame.place != "room1") others.push_back(frame);
  }
  const std::vector<Frame> room = framesOf("room1", 100, 4);
  const std::vector<Frame> later = framesOf("room1", 5000, 100);
  const Model before = train({opener(others)}, twoCueOptions()).model;
  const auto extended =
      std::make_shared<const Model>(trainIncrementally(before, {opener(room)}, {}).model);
  const auto at_once =
      std::make_shared<const Model>(train({opener(others), opener(room)}, twoCueOptions()).model);
  EXPECT_GT(fractionsOf(at_once, later).right, 0.9);
  EXPECT_GE(fractionsOf(extended, later).right, fractionsOf(at_once, later).right - 0.05);
}

TEST(TrainIncrementally, OneImageLeavesTheOtherRoomsAsTheyWere) {
  Frame frame;
  frame.image = drawRoom(2, 900);
  frame.place = "room2";
  expectOthersAsTheyWere({frame}, quickOptions());
}

TEST(TrainIncrementally, ARoomOfManyImagesLeavesTheOtherRoomsAsTheyWere) {
  expectOthersAsTheyWere(framesOf("room2", 900), twoCueOptions());
}

std::vector<Frame> darker(std::vector<Frame> frames, double factor) {
  for (Frame& frame : frames) frame.image = frame.image * factor;
  return frames;
}

TEST(TrainIncrementally, ARoomInAnotherLightLeavesTheOtherRoomsAsTheyWere) {
  const auto before =
      std::make_shared<const Model>(train({opener(drawFrames(4, 30))}, TrainingOptions()).model);
  const auto after = std::make_shared<const Model>(
      trainIncrementally(*before, {opener(darker(framesOf("room3", 900), 0.8))}, {0}).model);
  const std::vector<Frame> others = drawFrames(3, 25, 5000);
  EXPECT_NEAR(fractionsOf(after, others).right, fractionsOf(before, others).right, 0.02);
  EXPECT_NEAR(fractionsOf(after, others).unknown, fractionsOf(before, others).unknown, 0.02);
}

std::vector<Frame> realFrames(const std::string& run, double light) {
  std::vector<Frame> frames;
  const std::unique_ptr<Recording> recording = openFolderRecording(run);
  for (Frame frame; recording->next(frame);) frames.push_back(frame);
  return darker(std::move(frames), light);
}

// The new light must not become the distinguishing feature of the place learned in it.
TEST(TrainIncrementally, APlaceInTheDarkTakesNothingFromTheOtherPlacesOfARealCorridor) {
  constexpr double kDark = 0.35;
  const char* data = std::getenv("PLACE_RECOGNITION_TEST_DATA");
  const std::string root = std::string(data == nullptr ? "" : data) + "/corridor_two_runs/";
  if (data == nullptr || !std::filesystem::exists(root)) {
    GTEST_SKIP() << "No images of a real corridor: set PLACE_RECOGNITION_TEST_DATA.";
  }
  const auto before = std::make_shared<const Model>(
      train({opener(realFrames(root + "run1_ref", 1))}, TrainingOptions()).model);
  const std::vector<Frame> dark = realFrames(root + "run2_query", kDark);
  double change = 0;  // change of the rates of the other places, summed over the places
  for (const std::string& place : before->places) {
    std::vector<Frame> own, others;
    for (const Frame& frame : dark) (frame.place == place ? own : others).push_back(frame);
    const auto after =
        std::make_shared<const Model>(trainIncrementally(*before, {opener(own)}, {0}).model);
    change += fractionsOf(after, others).right - fractionsOf(before, others).right;
  }
  EXPECT_GE(change / static_cast<double>(before->places.size()), -0.02);
}

TEST(TrainIncrementally, LeavesWhatIsUnknownToTheFramesOfBefore) {
  const Model before = train({opener(drawFrames(3, 30))}, quickOptions()).model;
  std::vector<Frame> frames = darker(framesOf("room1", 900), 0.5);
  const Model after = trainIncrementally(before, {opener(frames)}, {0}).model;
  EXPECT_EQ(after.cue_weights, before.cue_weights);
  EXPECT_EQ(after.held_out.places, before.held_out.places);
  for (const Frame& frame : framesOf("room3", 900)) frames.push_back(frame);
  const Model with_new_room = trainIncrementally(before, {opener(frames)}, {0}).model;
  const std::vector<int>& places = with_new_room.held_out.places;
  EXPECT_EQ(std::count(places.begin(), places.end(), 1),
            std::count(before.held_out.places.begin(), before.held_out.places.end(), 1));
  EXPECT_EQ(std::count(places.begin(), places.end(), 3), 15) << "nothing else tells of this place";
}

}  // namespace
}  // namespace place_recognition
