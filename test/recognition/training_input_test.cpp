// Input that training leaves out, tolerates or refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "error_of.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "place_recognition/training.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// Returns the error message of train().
std::string refusal(const std::vector<Frame>& frames) {
  return errorOf([&] { train({opener(frames, "walk.bag")}, quickOptions(), 1); });
}

void expectFinite(const Training& training, const cv::Mat& image) {
  const std::string bytes = serializeModel(training.model);
  Recognizer recognizer(std::make_shared<const Model>(parseModel(bytes, "test")));
  const Recognition& answer = recognizer.recognize(image);
  EXPECT_TRUE(answer.probabilities.allFinite());
  EXPECT_TRUE(answer.decision_values.allFinite());
  EXPECT_NEAR(answer.probabilities.sum(), 1, 1e-9);
}

TEST(TrainingInput, LeavesOutWhatItCannotUse) {
  std::vector<Frame> frames = drawFrames(2, 12);
  frames[1].place.clear();
  frames[2].place.clear();
  frames[5].image = cv::Mat();
  frames[5].problem = "it is damaged and cannot be decoded";
  frames[14].image = cv::Mat::eye(3, 3, CV_8UC1) * 255;  // too small for any feature
  const Training training = train({opener(frames)}, quickOptions());
  EXPECT_EQ(training.images, 20u);
  EXPECT_EQ(training.model.provenance.skipped_images, 4u);
  EXPECT_EQ(training.model.provenance.place_images, (std::vector<std::uint64_t>{9, 11}));
  for (const std::string& sentence :
       {std::string("drawn: 2 images without a label are left out."),
        std::string("drawn: 2 images that cannot be used (frame5: it is damaged and cannot "
                    "be decoded) are left out.")}) {
    EXPECT_EQ(std::count(training.warnings.begin(), training.warnings.end(), sentence), 1)
        << sentence;
  }
}

TEST(TrainingInput, ACopyOfARunCountsOnce) {
  const std::vector<Frame> night = drawFrames(3, 20), day = drawFrames(3, 20, 500);
  const auto learned = [](const std::vector<RecordingOpener>& recordings,
                          std::vector<std::string>& warnings) {
    Training training = train(recordings, quickOptions());
    warnings = training.warnings;
    training.model.provenance.inputs.clear();
    training.model.provenance.sketches.clear();
    return serializeModel(training.model);
  };
  std::vector<std::string> none, copies, copy_of_part;
  const std::string once = learned({opener(night, "night"), opener(day, "day")}, none);
  EXPECT_EQ(none, std::vector<std::string>());
  EXPECT_EQ(learned({opener(night, "night"), opener(day, "day"), opener(night, "night.orig"),
                     opener(day, "day (copy)")},
                    copies),
            once);
  EXPECT_EQ(copies, (std::vector<std::string>{
                        "night.orig: 60 of 60 images are those of night; they count once.",
                        "day (copy): 60 of 60 images are those of day; they count once."}));

  std::vector<RecordingOpener> parts = openersOfParts(night, {20, 40});
  const std::string whole = learned(parts, none);
  parts.insert(parts.begin() + 1, parts[1]);
  EXPECT_EQ(learned(parts, copy_of_part), whole) << "the next part continues the one before";
  EXPECT_EQ(
      copy_of_part,
      (std::vector<std::string>{"part1: 20 of 20 images are those of part1; they count once."}));
}

TEST(TrainingInput, ImagesCountOnceOverAllRunsButWithinOneAsOftenAsTheyAre) {
  std::vector<Frame> standing = drawFrames(3, 20);
  for (int i = 10; i < 16; ++i) standing[i].image = standing[9].image;
  EXPECT_EQ(train({opener(standing)}, quickOptions()).images, 60u);
  EXPECT_EQ(train(openersOfParts(standing, {12}), quickOptions()).images, 60u);

  std::vector<Frame> grown = drawFrames(3, 21);
  const Training both =
      train({opener(drawFrames(3, 20), "folder"), opener(grown, "copy")}, quickOptions());
  EXPECT_EQ(both.images, 63u);
  EXPECT_EQ(
      both.warnings,
      (std::vector<std::string>{"copy: 60 of 63 images are those of folder; they count once."}));

  std::vector<Frame> unlabelled = drawFrames(3, 20);
  for (Frame& frame : unlabelled) frame.place.clear();
  EXPECT_EQ(
      train({opener(unlabelled, "recorded"), opener(drawFrames(3, 20), "labelled")}, quickOptions())
          .images,
      60u);
}

/// Returns an image of one colour with sensor noise.
cv::Mat uniformImage(const cv::Scalar& colour, int seed) {
  cv::Mat noise(72, 96, CV_16SC3);
  cv::RNG(static_cast<std::uint64_t>(seed + 1)).fill(noise, cv::RNG::UNIFORM, -3, 4);
  cv::Mat image;
  cv::add(cv::Mat(72, 96, CV_16SC3, colour), noise, image, cv::noArray(), CV_8U);
  return image;
}

TEST(TrainingInput, LeavesOutImagesOfOneColour) {
  const std::vector<Frame> good = drawFrames(2, 12);
  std::vector<Frame> frames = good;
  const cv::Scalar colours[] = {cv::Scalar::all(0), cv::Scalar::all(255), cv::Scalar::all(127),
                                cv::Scalar(0, 135, 0), cv::Scalar(255, 0, 0)};
  for (int i = 0; i < 5; ++i) {
    frames.push_back(good[0]);
    frames.back().image = uniformImage(colours[i], i);
    frames.back().name = "covered" + std::to_string(i);
  }
  const Training training = train({opener(frames)}, quickOptions());
  EXPECT_EQ(training.images, 24u);
  EXPECT_EQ(training.model.provenance.skipped_images, 5u);
  EXPECT_EQ(training.warnings,
            std::vector<std::string>{"drawn: 5 images of a single colour, as from a covered "
                                     "lens (the first: covered0) are left out."});

  for (Frame& frame : frames) {
    if (frame.place == "room1") frame.image = uniformImage(cv::Scalar::all(3), 7);
  }
  const std::string error = refusal(frames);
  EXPECT_NE(error.find("Only 'room0' of the 2 places"), std::string::npos) << error;
}

TEST(TrainingInput, RefusesBlackImages) {
  std::vector<Frame> frames = drawFrames(2, 6);
  for (Frame& frame : frames) frame.image = cv::Mat::zeros(72, 96, CV_8UC3);
  const std::string error = refusal(frames);
  EXPECT_NE(error.find("can be used (frame0: it shows nothing but one colour)"), std::string::npos)
      << error;
}

TEST(TrainingInput, SaysWhyItRefuses) {
  EXPECT_NE(refusal({}).find("no images in walk.bag"), std::string::npos) << refusal({});
  EXPECT_NE(refusal(drawFrames(1, 5)).find("'room0'"), std::string::npos);

  std::vector<Frame> unlabelled = drawFrames(2, 3);
  for (Frame& frame : unlabelled) frame.place.clear();
  EXPECT_NE(refusal(unlabelled).find("has a label"), std::string::npos) << refusal(unlabelled);

  std::vector<Frame> damaged = drawFrames(2, 3);
  for (Frame& frame : damaged) frame.image = cv::Mat(), frame.problem = "it is damaged";
  EXPECT_NE(refusal(damaged).find("it is damaged"), std::string::npos) << refusal(damaged);

  for (const char* place : {"a\nb", "\xff", "\xc0\x80", "\xed\xa0\x80", "unknown"}) {
    std::vector<Frame> frames = drawFrames(2, 3);
    frames[4].place = place;
    EXPECT_NE(refusal(frames).find("frame4"), std::string::npos) << refusal(frames);
  }
}

TEST(TrainingInput, RefusesAMissingNetworkBeforeReadingImages) {
  TrainingOptions options = quickOptions();
  options.cues[0].kernel.type = "gaussian";
  EmbeddingOptions embedding;
  embedding.network = "/nowhere/absent.onnx";
  options.cues[0].feature = embedding;
  const RecordingOpener unopened = []() -> std::unique_ptr<place_recognition::Recording> {
    throw std::logic_error("opened");
  };
  EXPECT_THROW(train({unopened}, options), Error);
}

TEST(TrainingInput, NamesTheKernelThatOverflows) {
  TrainingOptions options = quickOptions();
  options.cues[0].name = "edges";
  options.cues[0].kernel.type = "polynomial";
  options.cues[0].kernel.p = 1e31;
  options.cues[0].kernel.d = 10;
  const std::string error = errorOf([&] { train({opener(drawFrames(2, 12))}, options); });
  EXPECT_NE(error.find("cues.edges.kernel.p"), std::string::npos) << error;
}

TEST(TrainingInput, SurvivesOneImagePerRoom) {
  const Training training = train({opener(drawFrames(3, 1))}, quickOptions());
  EXPECT_EQ(training.warnings.size(), 3u);
  expectFinite(training, drawRoom(0, 7));
}

TEST(TrainingInput, SurvivesEqualImages) {
  std::vector<Frame> frames = drawFrames(3, 8);
  for (Frame& frame : frames) frame.image = drawRoom(0, 0);
  expectFinite(train({opener(frames)}, quickOptions()), drawRoom(0, 7));
}

TEST(TrainingInput, SurvivesARareRoom) {
  std::vector<Frame> frames = drawFrames(2, 50);
  frames.push_back(drawFrames(3, 1).back());
  const Training training = train({opener(frames)}, quickOptions());
  EXPECT_EQ(training.warnings.size(), 1u);
  expectFinite(training, drawRoom(2, 7));
}

}  // namespace
}  // namespace place_recognition
