// Degenerate runs, with every preset: training yields a sound model or a clear refusal, and never a
// NaN or an infinite number.

#include <gtest/gtest.h>

#include <cmath>

#include "error_of.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "reliability/preset_models.h"

namespace place_recognition {
namespace {

void expectFinite(const Recognition& answer) {
  EXPECT_NEAR(answer.probabilities.sum(), 1, 1e-9);
  EXPECT_TRUE(answer.probabilities.allFinite());
  EXPECT_TRUE(answer.decision_values.allFinite());
  EXPECT_TRUE(std::isfinite(answer.confidence));
  EXPECT_TRUE(std::isfinite(answer.evidence));
}

/// Expects that the model contains only finite numbers, also after it was saved, and that its
/// answers do.
void expectSound(const Model& trained, const std::vector<Frame>& frames) {
  // The reader refuses numbers that are not finite or out of range.
  const auto model = std::make_shared<const Model>(parseModel(serializeModel(trained), "trained"));
  Recognizer recognizer(model);
  for (std::size_t i = 0; i < frames.size(); i += 1 + frames.size() / 10) {
    expectFinite(recognizer.recognize(frames[i].image));
  }
  expectFinite(recognizer.recognize(drawRoom(2, 99)));
  expectFinite(recognizer.recognize(cv::Mat::zeros(72, 96, CV_8UC3)));
  expectFinite(recognizer.recognize(cv::Mat(72, 96, CV_8UC1, cv::Scalar(255))));
  expectFinite(recognizer.recognize(cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3))));
}

/// Returns whether `frames` can be learned. Expects a refusal to be a sentence.
bool trains(const std::vector<Frame>& frames, const TrainingOptions& options) {
  const std::string error =
      errorOf([&] { expectSound(train({opener(frames)}, options).model, frames); });
  if (error.empty()) return true;
  EXPECT_GT(error.size(), 20u) << error;
  return false;
}

std::vector<Frame> withImage(std::vector<Frame> frames, const cv::Mat& image) {
  for (Frame& frame : frames) frame.image = image;
  return frames;
}

class EveryPreset : public testing::TestWithParam<int> {
 protected:
  const TrainingOptions options_ = presets().at(static_cast<std::size_t>(GetParam()));
};

TEST_P(EveryPreset, OneImagePerRoom) { trains(drawFrames(3, 1), options_); }

TEST_P(EveryPreset, TwoImagesPerRoom) { trains(drawFrames(3, 2), options_); }

TEST_P(EveryPreset, IdenticalImages) {
  trains(withImage(drawFrames(3, 5), drawRoom(0, 1)), options_);
}

TEST_P(EveryPreset, BlackImages) {
  EXPECT_FALSE(trains(withImage(drawFrames(3, 5), cv::Mat::zeros(72, 96, CV_8UC3)), options_));
}

TEST_P(EveryPreset, ImagesOfTwoGreyHalves) {
  cv::Mat image(72, 96, CV_8UC1, cv::Scalar(255));
  image.colRange(0, 48) = 240;
  trains(withImage(drawFrames(3, 5), image), options_);
}

TEST_P(EveryPreset, OneBlackRoom) {
  std::vector<Frame> frames = drawFrames(3, 5);
  for (std::size_t i = 0; i < 5; ++i) frames[i].image = cv::Mat::zeros(72, 96, CV_8UC3);
  EXPECT_TRUE(trains(frames, options_));
}

TEST_P(EveryPreset, TinyImages) {
  const cv::Mat image = (cv::Mat_<std::uint8_t>(1, 2) << 9, 90);
  trains(withImage(drawFrames(2, 3), image), options_);
}

TEST_P(EveryPreset, ImagesOfTwoSizes) {
  std::vector<Frame> frames = drawFrames(2, 4);
  for (std::size_t i = 0; i < frames.size(); i += 2) {
    cv::resize(frames[i].image, frames[i].image, cv::Size(200, 61));
  }
  EXPECT_TRUE(trains(frames, options_));
}

TEST_P(EveryPreset, TimeThatRunsBackwards) {
  std::vector<Frame> frames = drawFrames(2, 6);
  for (Frame& frame : frames) frame.stamp = -frame.stamp;
  EXPECT_TRUE(trains(frames, options_));
}

INSTANTIATE_TEST_SUITE_P(DegenerateTraining, EveryPreset,
                         testing::Range(0, static_cast<int>(presets().size())));

TEST(DegenerateTraining, TwoHundredRooms) {
  std::vector<Frame> frames = drawFrames(3, 200);  // three kinds of image, 200 names
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].place = "room" + std::to_string(i % 200);
  EXPECT_TRUE(trains(frames, quickOptions()));
}

TEST(DegenerateTraining, ARoomOfOneInAHundred) {
  std::vector<Frame> frames = drawFrames(2, 198);
  frames.resize(200);
  EXPECT_TRUE(trains(frames, quickOptions()));
}

TEST(DegenerateTraining, NothingToTrainOn) {
  EXPECT_FALSE(trains({}, quickOptions()));
  std::vector<Frame> unlabelled = drawFrames(2, 4);
  for (Frame& frame : unlabelled) frame.place.clear();
  EXPECT_FALSE(trains(unlabelled, quickOptions()));
}

TEST(DegenerateTraining, EveryKernelAndBothKindsOfMachines) {
  for (const char* kernel :
       {"linear", "polynomial", "gaussian", "sigmoid", "chi-squared", "intersection"}) {
    for (const char* multiclass : {"one-against-all", "one-against-one"}) {
      TrainingOptions options = quickOptions();
      options.cues[0].kernel.type = kernel;
      options.svm.multiclass = multiclass;
      SCOPED_TRACE(std::string(kernel) + ", " + multiclass);
      trains(drawFrames(3, 1), options);
      trains(withImage(drawFrames(3, 5), drawRoom(0, 1)), options);
      EXPECT_TRUE(trains(drawFrames(3, 5), options));
    }
  }
}

TEST(DegenerateTraining, EveryReductionOfIdenticalImages) {
  for (const char* method : {"qr", "shared-qr", "shared-greedy"}) {
    TrainingOptions options = quickOptions();
    options.reduction.method = method;
    SCOPED_TRACE(method);
    trains(withImage(drawFrames(3, 5), drawRoom(0, 1)), options);
    EXPECT_TRUE(trains(drawFrames(3, 5), options));
  }
}

}  // namespace
}  // namespace place_recognition
