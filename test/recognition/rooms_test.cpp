// Real rooms, with one clip of each for training and one for testing. The bounds are the rates of a
// plain prototype of the method, minus two percentage points.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "place_recognition/recognizer.h"
#include "place_recognition/training.h"
#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

struct RoomsCase {
  const char* name;
  std::vector<std::string> descriptors;
  std::vector<double> scales;
  int bins;
  double forward;   // trained on clip1, tested on clip2
  double backward;  // in the other direction
};

class RealRooms : public testing::TestWithParam<RoomsCase> {};

double rate(const std::string& train_folder, const std::string& test_folder) {
  CrfhOptions crfh;
  const RoomsCase& parameters = RealRooms::GetParam();
  crfh.descriptors = parameters.descriptors;
  crfh.scales = parameters.scales;
  crfh.bins = {parameters.bins};
  TrainingOptions options;
  options.cues = {CueOptions()};
  options.cues[0].feature = crfh;
  Training training = train({[&] { return openFolderRecording(train_folder); }}, options);
  const auto model = std::make_shared<const Model>(std::move(training.model));

  Recognizer recognizer(model);
  const std::unique_ptr<Recording> recording = openFolderRecording(test_folder);
  std::vector<int> truth, answers;
  for (Frame frame; recording->next(frame);) {
    const auto place = std::find(model->places.begin(), model->places.end(), frame.place);
    truth.push_back(static_cast<int>(place - model->places.begin()));
    answers.push_back(recognizer.recognize(frame.image).place);
  }
  return averageRate(truth, answers, model->places.size());
}

TEST_P(RealRooms, AreTold) {
  const char* data = std::getenv("PLACE_RECOGNITION_TEST_DATA");
  const std::string root = std::string(data == nullptr ? "" : data) + "/ie_rooms/";
  if (data == nullptr || !std::filesystem::exists(root)) {
    GTEST_SKIP() << "No images of real rooms: set PLACE_RECOGNITION_TEST_DATA.";
  }
  EXPECT_GE(rate(root + "clip1", root + "clip2"), GetParam().forward);
  EXPECT_GE(rate(root + "clip2", root + "clip1"), GetParam().backward);
}

INSTANTIATE_TEST_SUITE_P(
    ClipToClip, RealRooms,
    testing::Values(RoomsCase{"Default", {"Lxx", "Lxy", "Lyy"}, {1, 4}, 28, 0.526, 0.484},
                    RoomsCase{"ColourOpponents", {"L", "C1", "C2"}, {4}, 16, 0.834, 0.775},
                    RoomsCase{"Rgb", {"R", "G", "B"}, {1}, 16, 0.809, 0.802}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace place_recognition
