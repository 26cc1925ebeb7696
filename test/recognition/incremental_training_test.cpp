#include <gtest/gtest.h>

#include "error_of.h"
#include "features/small_network.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// Returns the fraction of correct answers to new frames of all drawn rooms.
double rateOn(Model model, int rooms) {
  const auto shared = std::make_shared<const Model>(std::move(model));
  Recognizer recognizer(shared);
  double right = 0;
  const std::vector<Frame> frames = drawFrames(rooms, 8, 5000);
  for (const Frame& frame : frames) {
    const Recognition& answer = recognizer.recognize(frame.image);
    right += shared->places[static_cast<std::size_t>(answer.place)] == frame.place ? 1 : 0;
  }
  return right / static_cast<double>(frames.size());
}

TEST(TrainIncrementally, ANewRoomJoinsTheOnesThatAreRemembered) {
  const Training before = train({opener(drawFrames(3, 15), "monday")}, quickOptions());
  const Training after =
      trainIncrementally(before.model, {opener(framesOf("room3", 100), "tuesday")}, {0});
  EXPECT_EQ(after.model.places, (std::vector<std::string>{"room0", "room1", "room2", "room3"}));
  EXPECT_EQ(after.images, 15u);
  EXPECT_EQ(after.model.provenance.place_images, (std::vector<std::uint64_t>{15, 15, 15, 15}));
  EXPECT_EQ(after.model.provenance.inputs, (std::vector<std::string>{"monday", "tuesday"}));
}

TEST(TrainIncrementally, RefusesOptionsOutOfRange) {
  const Training before = train({opener(drawFrames(3, 15))}, quickOptions());
  for (const IncrementalOptions& options :
       {IncrementalOptions{-1, 0}, IncrementalOptions{5, -0.1}, IncrementalOptions{5, 1.1}}) {
    EXPECT_THROW(trainIncrementally(before.model, {opener(drawFrames(3, 2))}, options), Error);
  }
}

TEST(TrainIncrementally, ImagesThatAreKnownAlreadyChangeNoDecisionValue) {
  TrainingOptions options = quickOptions();
  options.reduction.method = "none";
  const std::vector<Frame> frames = drawFrames(3, 15);
  Training before = train({opener(frames, "monday")}, options);
  const std::vector<Frame> again(frames.begin(), frames.begin() + 15);
  Training after = trainIncrementally(before.model, {opener(again, "tuesday")}, {});
  Recognizer old(std::make_shared<const Model>(std::move(before.model)));
  Recognizer learned(std::make_shared<const Model>(std::move(after.model)));
  for (unsigned i = 0; i < 30; ++i) {
    const cv::Mat image = drawRoom(static_cast<int>(i % 3), 700 + i);
    EXPECT_EQ(learned.recognize(image).decision_values, old.recognize(image).decision_values);
  }
}

TEST(TrainIncrementally, KeepsToItsLimitAndRemembersRoomsThatDoNotComeAgain) {
  TrainingOptions options = twoCueOptions();
  options.reduction.method = "none";
  Training training = train({opener(drawFrames(3, 20), "monday")}, options);
  for (const unsigned first_frame : {100u, 200u, 300u}) {
    training = trainIncrementally(training.model, {opener(framesOf("room1", first_frame))}, {20});
    for (const Classifier& classifier : training.model.classifiers) {
      EXPECT_LE(classifier.supportVectorCount(), 20u);
    }
  }
  EXPECT_GT(rateOn(std::move(training.model), 3), 0.85);
}

TEST(TrainIncrementally, WarnsOfFiguresThatAreTooGood) {
  const Training before = train({opener(drawFrames(3, 20), "monday")}, twoCueOptions());
  const auto warnings = [&](unsigned first_frame, int limit) {
    std::string text;
    const std::vector<RecordingOpener> runs{opener(drawFrames(3, 20, first_frame), "tuesday")};
    for (const std::string& warning : trainIncrementally(before.model, runs, {limit}).warnings) {
      text += warning;
    }
    return text;
  };
  EXPECT_EQ(warnings(100, 0), "");
  EXPECT_NE(warnings(0, 0).find("already trained on tuesday"), std::string::npos);
  EXPECT_NE(warnings(100, 2).find("keeps 2 support vectors of"), std::string::npos);
}

TEST(TrainIncrementally, KeepsTheNetworkThatTheModelCarries) {
  TrainingOptions options = twoCueOptions();
  options.cues[1].feature = SmallNetwork::options();
  options.cues[1].kernel.type = "gaussian";
  const std::string file = serializeModel(train({opener(drawFrames(3, 12))}, options).model);
  const Training after =
      trainIncrementally(parseModel(file, "once"), {opener(drawFrames(3, 6, 700))}, {15});
  const auto& embedding = std::get<EmbeddingOptions>(after.model.options.cues[1].feature);
  EXPECT_EQ(embedding.loaded->onnx, SmallNetwork::onnx());
  EXPECT_EQ(embedding.loaded->sha256, SmallNetwork::network()->sha256);
  const Model read = parseModel(serializeModel(after.model), "twice");
  EXPECT_GT(rateOn(parseModel(serializeModel(read), "thrice"), 3), 0.85);
}

TEST(TrainIncrementally, FromALoadedModelGivesTheSameBytesWhateverTheThreads) {
  const Training before = train({opener(drawFrames(3, 12))}, twoCueOptions());
  const std::string file = serializeModel(before.model);
  const std::vector<RecordingOpener> recordings{opener(drawFrames(3, 6, 700))};
  const std::string once =
      serializeModel(trainIncrementally(before.model, recordings, {15}, 1).model);
  EXPECT_EQ(serializeModel(trainIncrementally(parseModel(file, "once"), recordings, {15}, 3).model),
            once);
}

TEST(TrainIncrementally, WithoutALimitKeepsAsManyVectorsAsItNeeds) {
  TrainingOptions options = quickOptions();
  const Training before = train({opener(drawFrames(3, 30))}, options);
  const Training after = trainIncrementally(before.model, {opener(framesOf("room1", 900))}, {0});
  EXPECT_EQ(after.model.asked.reduction.method, "auto");
  EXPECT_EQ(after.model.supportVectorCount(), after.unreduced_vectors[0]);
  // A limit applies only to the run that it was given for.
  const Training limited = trainIncrementally(before.model, {opener(framesOf("room1", 900))}, {10});
  EXPECT_LE(limited.model.supportVectorCount(), 10u);
  EXPECT_EQ(limited.model.asked.reduction.method, "auto");
}

TEST(TrainIncrementally, FeaturesAndGammaStayThoseOfTheModel) {
  const Training before = train({opener(drawFrames(3, 12))}, quickOptions());
  const Training after = trainIncrementally(before.model, {opener(drawFrames(3, 12, 60))}, {0});
  EXPECT_EQ(after.model.options.cues[0].kernel.gamma, before.model.options.cues[0].kernel.gamma);
  EXPECT_GT(before.model.options.cues[0].kernel.gamma, 0);
}

IncrementalOptions from(const Model& other) {
  IncrementalOptions incremental;
  incremental.other = &other;
  return incremental;
}

// Two robots, each of which has seen two of three rooms.
TEST(TrainIncrementally, AnotherModelBringsItsRooms) {
  std::vector<Frame> first, second;
  for (const Frame& frame : drawFrames(3, 20)) {
    if (frame.place != "room2") first.push_back(frame);
  }
  for (const Frame& frame : drawFrames(3, 20, 100)) {
    if (frame.place != "room0") second.push_back(frame);
  }
  TrainingOptions options = twoCueOptions();
  options.reduction.method = "none";
  const Model a = train({opener(first, "first")}, options).model;
  const Model b = train({opener(second, "second")}, options).model;
  Training joined = trainIncrementally(a, {}, from(b));
  EXPECT_EQ(joined.images, 0u);
  EXPECT_EQ(joined.model.places, (std::vector<std::string>{"room0", "room1", "room2"}));
  EXPECT_EQ(joined.model.provenance.place_images, (std::vector<std::uint64_t>{20, 40, 20}));
  EXPECT_EQ(joined.model.provenance.inputs, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(joined.model.validatedPlaces(), joined.model.places) << "by the frames of both";
  EXPECT_EQ(joined.model.held_out.places.size(),
            a.held_out.places.size() + b.held_out.places.size());
  EXPECT_GT(rateOn(std::move(joined.model), 3), 0.85);
}

TEST(TrainIncrementally, ARunCanComeWithAnotherModel) {
  const Model a = train({opener(drawFrames(2, 15))}, quickOptions()).model;
  const Model b = train({opener(drawFrames(3, 15, 200))}, quickOptions()).model;
  const Training joined = trainIncrementally(a, {opener(framesOf("room3", 400))}, from(b));
  EXPECT_EQ(joined.images, 15u);
  EXPECT_EQ(joined.model.places, (std::vector<std::string>{"room0", "room1", "room2", "room3"}));
}

TEST(TrainIncrementally, AModelOfOtherFeaturesCannotJoin) {
  const auto problem = [](const TrainingOptions& options, std::vector<Frame> frames) {
    Model a = train({opener(drawFrames(2, 8))}, quickOptions()).model;
    Model b = train({opener(std::move(frames))}, options).model;
    a.name = "ours", b.name = "theirs";
    return errorOf([&] { trainIncrementally(a, {}, from(b)); });
  };
  TrainingOptions options = quickOptions();
  EXPECT_EQ(problem(options, drawFrames(3, 8)), "");
  EXPECT_EQ(
      problem(twoCueOptions(), drawFrames(2, 8)),
      "The model 'theirs' cannot join 'ours': its cues are different; train both with the same "
      "configuration.");
  std::get<CrfhOptions>(options.cues[0].feature).bins = {7};
  EXPECT_NE(problem(options, drawFrames(2, 8)).find("cue"), std::string::npos);
  options = quickOptions();
  options.image.max_width = 50;
  EXPECT_NE(problem(options, drawFrames(2, 8)).find("pixels"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
