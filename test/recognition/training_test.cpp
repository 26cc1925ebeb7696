#include "place_recognition/training.h"
#include "base/options.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "features/small_network.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// What train() says when it refuses.
std::string refusal(const std::vector<Frame>& frames) {
  try {
    train({opener(frames, "walk.bag")}, quickOptions(), 1);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

/// Fraction of right answers on new images of the drawn rooms.
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

TEST(Training, GivesTheSameBytesWhateverTheThreads) {
  const std::vector<RecordingOpener> recordings{opener(drawFrames(3, 9))};
  const std::string once = serializeModel(train(recordings, twoCueOptions(), 1).model);
  EXPECT_EQ(serializeModel(train(recordings, twoCueOptions(), 1).model), once);
  EXPECT_EQ(serializeModel(train(recordings, twoCueOptions(), 2).model), once);
  EXPECT_EQ(serializeModel(train(recordings, twoCueOptions(), 5).model), once);
}

TEST(Training, LeavesOutWhatItCannotUse) {
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

/// An image of one colour with the noise of a sensor.
cv::Mat uniformImage(const cv::Scalar& colour, int seed) {
  cv::Mat noise(72, 96, CV_16SC3);
  cv::RNG(static_cast<std::uint64_t>(seed + 1)).fill(noise, cv::RNG::UNIFORM, -3, 4);
  cv::Mat image;
  cv::add(cv::Mat(72, 96, CV_16SC3, colour), noise, image, cv::noArray(), CV_8U);
  return image;
}

TEST(Training, LeavesOutImagesOfOneColour) {
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
  try {
    train({opener(frames)}, quickOptions());
    ADD_FAILURE() << "no error";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("show one place, 'room0'"), std::string::npos) << e.what();
  }
}

/// The same frames from a camera of `factor` times the size.
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

TEST(Training, SaysWhyItRefuses) {
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

TEST(Training, StopsWhenAsked) {
  for (const char* stage : {"Reading drawn", "Choosing gamma", "Training", "Calibrating"}) {
    const auto progress = [stage](const std::string& now, double) { return now != stage; };
    EXPECT_THROW(train({opener(drawFrames(2, 6))}, quickOptions(), 2, progress), Cancelled)
        << stage;
  }
}

TEST(Training, ReportsFractionsThatRise) {
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

void expectFinite(const Training& training, const cv::Mat& image) {
  const std::string bytes = serializeModel(training.model);
  Recognizer recognizer(std::make_shared<const Model>(parseModel(bytes, "test")));
  const Recognition& answer = recognizer.recognize(image);
  EXPECT_TRUE(answer.probabilities.allFinite());
  EXPECT_TRUE(answer.decision_values.allFinite());
  EXPECT_NEAR(answer.probabilities.sum(), 1, 1e-9);
}

TEST(Training, SurvivesOneImageARoom) {
  const Training training = train({opener(drawFrames(3, 1))}, quickOptions());
  EXPECT_EQ(training.warnings.size(), 3u);
  expectFinite(training, drawRoom(0, 7));
}

TEST(Training, SurvivesEqualImages) {
  std::vector<Frame> frames = drawFrames(3, 8);
  for (Frame& frame : frames) frame.image = drawRoom(0, 0);
  expectFinite(train({opener(frames)}, quickOptions()), drawRoom(0, 7));
}

TEST(Training, RefusesBlackImages) {
  std::vector<Frame> frames = drawFrames(2, 6);
  for (Frame& frame : frames) frame.image = cv::Mat::zeros(72, 96, CV_8UC3);
  try {
    train({opener(frames)}, quickOptions());
    ADD_FAILURE() << "no error";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("can be used (frame0: it shows nothing but one colour)"),
              std::string::npos)
        << e.what();
  }
}

TEST(Training, SurvivesARareRoom) {
  std::vector<Frame> frames = drawFrames(2, 50);
  frames.push_back(drawFrames(3, 1).back());
  const Training training = train({opener(frames)}, quickOptions());
  EXPECT_EQ(training.warnings.size(), 1u);
  expectFinite(training, drawRoom(2, 7));
}

/// The frames of three rooms, one after the other, and back to the first if `returns`.
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

  // Unlabelled frames while a door is passed are part of the drive.
  std::vector<Frame> frames = driveOf(true);
  frames[19].place = frames[20].place = "";
  for (std::size_t i = 40; i < frames.size(); ++i) frames[i].stamp += 10;  // after room1
  const Adjacency gaps = train({opener(frames)}, quickOptions()).model.adjacency;
  EXPECT_TRUE(gaps.joined(0, 1));
  EXPECT_FALSE(gaps.joined(1, 2));  // too long unseen

  const Adjacency sorted = train({opener(driveOf(false))}, quickOptions()).model.adjacency;
  EXPECT_TRUE(sorted.empty());
}

TEST(TrainingOptions, ReadBackAsWritten) {
  const std::string text = writeOptions(TrainingOptions());
  TrainingOptions options;
  readOptions(parseYaml(text, "defaults"), "", options);
  EXPECT_EQ(writeOptions(options), text);
}

TEST(Train, SaysThatNothingWasValidated) {
  const Training training = train({opener(drawFrames(2, 1))}, quickOptions());
  EXPECT_TRUE(training.model.validatedPlaces().empty());
  EXPECT_EQ(train({opener(drawFrames(2, 12))}, quickOptions()).model.validatedPlaces(),
            (std::vector<std::string>{"room0", "room1"}));
}

TEST(Train, NamesTheKernelThatOverflows) {
  TrainingOptions options = quickOptions();
  options.cues[0].name = "edges";
  options.cues[0].kernel.type = "polynomial";
  options.cues[0].kernel.p = 1e31;
  options.cues[0].kernel.d = 10;
  try {
    train({opener(drawFrames(2, 12))}, options);
    ADD_FAILURE() << "no complaint";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("cues.edges.kernel.p"), std::string::npos) << e.what();
  }
}

TEST(TrainingOptions, NamesTheFieldOutOfRange) {
  const auto complaint = [](const TrainingOptions& options) {
    try {
      options.check();
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  TrainingOptions options;
  EXPECT_EQ(complaint(options), "");
  options.validation.folds = 1;
  EXPECT_NE(complaint(options).find("validation.folds"), std::string::npos);
  options = TrainingOptions();
  options.image.max_width = -1;
  EXPECT_NE(complaint(options).find("image.max_width"), std::string::npos);
  options = TrainingOptions();
  options.unknown.false_alarm_rate = 1.5;
  EXPECT_NE(complaint(options).find("unknown.false_alarm_rate"), std::string::npos);
  options = TrainingOptions();
  options.cues[0].kernel.type = "cubic";
  EXPECT_NE(complaint(options).find("Cue 'colours'"), std::string::npos);
  for (const char* kernel : {"chi-squared", "intersection", "local-match"}) {
    options.cues[0].feature = SmallNetwork::options();
    options.cues[0].kernel.type = kernel;
    EXPECT_NE(complaint(options).find("use one of: linear, polynomial, gaussian, sigmoid"),
              std::string::npos);
  }
  options = TrainingOptions();
  options.cues.push_back(options.cues[0]);
  EXPECT_NE(complaint(options).find("'colours'"), std::string::npos);
  options.cues.clear();
  EXPECT_NE(complaint(options).find("'cues'"), std::string::npos);
}

TEST(Training, RefusesANetworkThatIsNotThereBeforeItReadsAImage) {
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

TEST(Train, NamesPlacesThatLookAlike) {
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
