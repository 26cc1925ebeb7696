#include "evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "error_of.h"
#include "evaluation/made_up_evaluation.h"
#include "evaluation/result_table.h"
#include "evaluation/summary.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

TEST(Summary, CountsRoomsByTheMostProbablePlace) {
  const Summary summary = summarize(madeUpEvaluation());
  ASSERT_EQ(summary.rooms.size(), 2u);  // the lift was never learned
  EXPECT_EQ(summary.rooms[0].count, 5u);
  EXPECT_EQ(summary.rooms[0].correct, 3u);
  EXPECT_EQ(summary.rooms[0].unknown, 2u);
  EXPECT_DOUBLE_EQ(summary.rooms[1].rate(), 1);
  EXPECT_DOUBLE_EQ(summary.average_rate, (0.6 + 1) / 2);
  EXPECT_DOUBLE_EQ(summary.unknown_share, 2.0 / 6);
}

TEST(Summary, KeepsRunsApart) {
  const Summary summary = summarize(madeUpEvaluation());
  ASSERT_EQ(summary.recordings.size(), 2u);
  EXPECT_EQ(summary.recordings[0].condition, "day");
  EXPECT_DOUBLE_EQ(summary.recordings[0].average_rate.value(), (2.0 / 3 + 1) / 2);
  ASSERT_EQ(summary.recordings[1].rooms.size(), 1u);
  EXPECT_DOUBLE_EQ(summary.recordings[1].average_rate.value(), 0.5);
  EXPECT_DOUBLE_EQ(summary.test_set_rate, (2.0 / 3 + 1 + 0.5) / 3);
}

TEST(Summary, ConfusionHasARowForEveryTruth) {
  const Confusion confusion = summarize(madeUpEvaluation()).confusion;
  const std::vector<std::vector<std::uint64_t>> counts{{3, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(confusion.counts, counts);
  EXPECT_EQ(confusion.none, (std::vector<std::uint64_t>{1, 0, 0}));
}

TEST(Summary, TellsKnownFromUnknown) {
  const Summary summary = summarize(madeUpEvaluation());
  ASSERT_TRUE(summary.unknown);
  // Learned 0.9 0.8 0.95 0.7 0.6 0 against 0.4 0.5: ten of twelve pairs are in order.
  EXPECT_DOUBLE_EQ(summary.unknown->roc_area, 10.0 / 12);
  EXPECT_DOUBLE_EQ(summary.unknown->detection_rate, 0.5);
  EXPECT_DOUBLE_EQ(summary.unknown->false_alarm_rate, 2.0 / 6);
}

TEST(Summary, MeasuresConfidenceOnLearnedPlaces) {
  const Summary summary = summarize(madeUpEvaluation());
  // Bins: 0.95 wrong and 0.9 right; 0.8; 0.7; 0.6, all right; 0 without an answer.
  EXPECT_NEAR(summary.calibration_error, (0.85 + 0.2 + 0.3 + 0.4 + 0) / 6, 1e-12);
  EXPECT_EQ(summary.risk_coverage.size(), 6u);
  EXPECT_DOUBLE_EQ(summary.latency_p50, 0.005);
  EXPECT_DOUBLE_EQ(summary.latency_p99, 0.008);
}

std::shared_ptr<const Model> model() {
  static const auto trained =
      std::make_shared<const Model>(train({opener(drawFrames(3, 12))}, quickOptions()).model);
  return trained;
}

std::string refusal(const std::vector<Frame>& frames) {
  return errorOf([&] { evaluate(model(), {opener(frames, "walk.bag")}); });
}

TEST(Evaluate, AnswersEveryLabelledImage) {
  std::vector<Frame> frames = drawFrames(4, 6, 200);  // room3 was never learned
  frames[0].place.clear();
  frames[7].image = cv::Mat();
  frames[8].image = cv::Mat::zeros(72, 96, CV_8UC3);  // not an error of the model
  const Evaluation evaluation =
      evaluate(model(), {opener(frames, "day"), opener(drawFrames(2, 3, 300), "night")}, 2);
  EXPECT_EQ(evaluation.frames.size(), 24u - 3 + 6);
  EXPECT_EQ(evaluation.places, (std::vector<std::string>{"room0", "room1", "room2", "room3"}));
  EXPECT_EQ(evaluation.model_places, 3u);
  EXPECT_EQ(evaluation.recordings, (std::vector<std::string>{"day", "night"}));
  EXPECT_EQ(evaluation.frames.back().recording, 1);
  EXPECT_EQ(evaluation.warnings.size(), 4u);
  EXPECT_GT(summarize(evaluation).average_rate, 0.8);
}

TEST(Evaluate, KeepsSeveralCamerasApart) {
  std::vector<Frame> frames = drawFrames(3, 20);
  const auto model = std::make_shared<const Model>(train({opener(frames)}, quickOptions()).model);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].camera = i % 2 == 0 ? 1 : 0;
  for (std::size_t i = 1; i < frames.size(); i += 2) frames[i].image = drawRoom(2, 900);
  const Evaluation evaluation = evaluate(model, {opener(frames, "robot.bag", {"/rear", "/front"}),
                                                 opener(drawFrames(3, 20), "one.bag")});
  EXPECT_EQ(evaluation.cameras, (std::vector<std::string>{"/rear", "/front", ""}));
  const Summary summary = summarize(evaluation);
  ASSERT_EQ(summary.cameras.size(), 3u);
  EXPECT_EQ(summary.cameras[0].count, 30u);  // the rear camera sees one room everywhere
  EXPECT_NEAR(summary.cameras[0].average_rate.value(), 1.0 / 3, 1e-9);
  EXPECT_EQ(summary.cameras[1].count, 30u);
  EXPECT_EQ(summary.cameras[2].name, "images in folders");
  EXPECT_NEAR(summary.cameras[1].average_rate.value(), 1, 0.1);
  EXPECT_NE(resultTable(evaluation, summary).find("/front"), std::string::npos);
}

TEST(Evaluate, PartsOfARecordingAreAnsweredAsTheWhole) {
  std::vector<Frame> whole;
  for (int lap = 0; lap < 3; ++lap) {
    for (Frame frame : drawFrames(3, 20, 400 + 20 * static_cast<unsigned>(lap))) {
      frame.stamp = 0.5 * static_cast<double>(whole.size());
      if (lap == 1) frame.image = drawRoom(4, static_cast<unsigned>(whole.size()));
      whole.push_back(frame);
    }
  }
  const std::vector<Frame> one(whole.begin(), whole.begin() + 70);
  std::vector<Frame> two(whole.begin() + 70, whole.end());
  const Evaluation expected = evaluate(model(), {opener(whole, "run.bag")});
  const Evaluation parts = evaluate(model(), {opener(one, "run_0.bag"), opener(two, "run_1.bag")});
  EXPECT_EQ(parts.recordings, std::vector<std::string>{"run_0.bag"});
  EXPECT_EQ(summarize(parts).recordings.size(), 1u);
  ASSERT_EQ(parts.frames.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(parts.frames[i].evidence, expected.frames[i].evidence) << i;
    EXPECT_EQ(parts.frames[i].place_over_time, expected.frames[i].place_over_time) << i;
    EXPECT_EQ(parts.frames[i].place_smoothed, expected.frames[i].place_smoothed) << i;
    EXPECT_EQ(parts.frames[i].recording, 0) << i;
  }
  ASSERT_TRUE(overTime(parts));
  EXPECT_EQ(overTime(parts)->all.frames, overTime(expected)->all.frames);
  EXPECT_EQ(overTime(parts)->delays, overTime(expected)->delays);

  for (Frame& frame : two) frame.stamp += 10;  // another drive
  const Evaluation drives = evaluate(model(), {opener(one, "1.bag"), opener(two, "2.bag")});
  EXPECT_EQ(drives.recordings.size(), 2u);
  bool differs = false;
  for (std::size_t i = 70; i < whole.size(); ++i) {
    differs = differs || drives.frames[i].evidence != expected.frames[i].evidence;
  }
  EXPECT_TRUE(differs);
}

/// How many runs two recordings are.
std::size_t runsOf(const std::vector<Frame>& one, const std::vector<Frame>& two,
                   const std::vector<std::string>& cameras) {
  return evaluate(model(), {opener(one, "run_0.bag", cameras), opener(two, "run_1.bag", cameras)})
      .recordings.size();
}

TEST(Evaluate, APartMayStartBetweenTheImagesOfOneMoment) {
  std::vector<Frame> frames = drawFrames(3, 20, 400);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].camera = static_cast<int>(i % 2);
    frames[i].stamp = 0.5 * static_cast<double>(i / 2) - 0.02 * frames[i].camera;
  }
  const std::vector<std::string> cameras{"/front", "/rear"};
  const auto parts = [&](std::size_t border) {
    const auto middle = frames.begin() + static_cast<std::ptrdiff_t>(border);
    return runsOf({frames.begin(), middle}, {middle, frames.end()}, cameras);
  };
  EXPECT_EQ(parts(30), 1u);
  EXPECT_EQ(parts(31), 1u);
  EXPECT_EQ(runsOf(frames, frames, cameras), 2u);
}

TEST(Evaluate, APartMayStartAmongFramesThatAreLeftOut) {
  std::vector<Frame> frames = drawFrames(3, 20, 400);
  for (std::size_t i = 25; i < 30; ++i) frames[i].place.clear();
  for (std::size_t i = 30; i < 35; ++i) frames[i].image = cv::Mat();
  const auto middle = frames.begin() + 30;
  EXPECT_EQ(runsOf({frames.begin(), middle}, {middle, frames.end()}, {""}), 1u);
}

TEST(Evaluate, KeepsTheMostConfidentMistakes) {
  std::vector<Frame> frames = drawFrames(3, 6, 200);
  for (Frame& frame : frames) frame.place = frame.place == "room0" ? "room1" : "room0";
  const Evaluation evaluation = evaluate(model(), {opener(frames)}, 4);
  ASSERT_EQ(evaluation.wrong.size(), 4u);
  std::vector<double> mistakes;
  for (const FrameResult& frame : evaluation.frames) {
    if (!frame.correct()) mistakes.push_back(frame.confidence);
  }
  std::sort(mistakes.rbegin(), mistakes.rend());
  for (std::size_t i = 0; i < 4; ++i) {
    const FrameResult& frame = evaluation.frames[evaluation.wrong[i].frame];
    EXPECT_FALSE(frame.correct());
    EXPECT_EQ(frame.confidence, mistakes[i]);
    const std::string& jpeg = evaluation.wrong[i].jpeg;
    const std::vector<unsigned char> bytes(jpeg.begin(), jpeg.end());
    EXPECT_EQ(cv::imdecode(bytes, cv::IMREAD_COLOR).size(), cv::Size(96, 72));
  }
}

TEST(Evaluate, SaysWhyItRefuses) {
  EXPECT_NE(refusal({}).find("no images in walk.bag"), std::string::npos);
  std::vector<Frame> frames = drawFrames(2, 2);
  for (Frame& frame : frames) frame.place = "attic";
  EXPECT_NE(refusal(frames).find("attic"), std::string::npos) << refusal(frames);
  for (Frame& frame : frames) frame.place.clear();
  EXPECT_NE(refusal(frames).find("label"), std::string::npos) << refusal(frames);
}

TEST(Evaluate, StopsWhenAsked) {
  EXPECT_THROW(evaluate(model(), {opener(drawFrames(2, 2))}, 1,
                        [](const std::string&, double fraction) { return fraction < 0.5; }),
               Cancelled);
}

}  // namespace
}  // namespace place_recognition
