// How support vectors age while a model learns on.
#include <gtest/gtest.h>

#include "learning/classifier_parts.h"
#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// Counts a model's support vectors of a given age, in one room or, if `room` is empty, in all.
int countOfAge(const Model& model, int age, const std::string& room) {
  int count = 0;
  for (const VectorOrigin& origin : ClassifierParts::of(model.classifiers[0]).origins) {
    const std::string& place = model.places[static_cast<std::size_t>(origin.place)];
    count += origin.age == age && (room.empty() || place == room) ? 1 : 0;
  }
  return count;
}

TEST(Forgetting, ViewsAgeAsTheirRoomIsLearnedAgain) {
  TrainingOptions options = quickOptions();
  options.reduction.method = "none";
  Model model = train({opener(drawFrames(3, 15))}, options).model;
  EXPECT_EQ(countOfAge(model, 0, ""), static_cast<int>(model.supportVectorCount()));
  for (const unsigned first_frame : {100u, 200u}) {
    const Model read = parseModel(serializeModel(model), "read");
    std::vector<Frame> darker;  // unlike those already known
    for (const Frame& frame : drawFrames(4, 15, first_frame)) {
      if (frame.place != "room1") continue;
      darker.push_back(frame);
      darker.back().image = frame.image * (40.0 / first_frame);
    }
    model = trainIncrementally(read, {opener(darker)}, {}).model;
  }
  EXPECT_GT(countOfAge(model, 0, "room1"), 0);
  EXPECT_GT(countOfAge(model, 1, "room1"), 0);
  EXPECT_GT(countOfAge(model, 2, "room1"), 0);
  EXPECT_GT(countOfAge(model, 0, "room0"), 0);
  EXPECT_EQ(countOfAge(model, 1, "room0") + countOfAge(model, 2, "room0"), 0)
      << "a room that does not come again is not forgotten";
}

// After a change of light, earlier views only matter for recognizing similar views.
TEST(Forgetting, KeepsFewerOldViews) {
  TrainingOptions options = quickOptions();
  options.reduction.method = "none";
  const Model before = train({opener(drawFrames(3, 25))}, options).model;
  std::vector<Frame> darker = drawFrames(3, 25, 300);
  for (Frame& frame : darker) frame.image = frame.image / 2;
  const auto oldViews = [&](double forgetting) {
    const Model after = trainIncrementally(before, {opener(darker)}, {12, forgetting}).model;
    EXPECT_EQ(after.supportVectorCount(), 12u);
    return countOfAge(after, 1, "");
  };
  EXPECT_LT(oldViews(0.95), oldViews(0));
}

}  // namespace
}  // namespace place_recognition
