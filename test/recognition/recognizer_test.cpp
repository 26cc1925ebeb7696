#include "place_recognition/recognizer.h"

#include <gtest/gtest.h>

#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

std::shared_ptr<const Model> modelOf(const TrainingOptions& options) {
  return std::make_shared<const Model>(train({opener(drawFrames(3, 12))}, options).model);
}

TEST(Recognizer, AnswersWithProbabilitiesOfTheLargestDecisionValue) {
  Recognizer recognizer(modelOf(twoCueOptions()));
  for (const Frame& frame : drawFrames(3, 8, 300)) {
    const Recognition& answer = recognizer.recognize(frame.image);
    EXPECT_NEAR(answer.probabilities.sum(), 1, 1e-12);
    Eigen::Index most_probable, largest_value;
    EXPECT_EQ(answer.confidence, answer.probabilities.maxCoeff(&most_probable));
    answer.decision_values.maxCoeff(&largest_value);
    EXPECT_EQ(answer.place, most_probable);
    EXPECT_EQ(answer.place, largest_value);
    EXPECT_EQ(answer.known, answer.evidence >= recognizer.model().unknown_threshold);
    EXPECT_EQ(answer.reason, "");
  }
}

TEST(Recognizer, AnswersTheSameFromTheModelFile) {
  const std::shared_ptr<const Model> model = modelOf(twoCueOptions());
  Recognizer trained(model);
  Recognizer loaded(std::make_shared<const Model>(parseModel(serializeModel(*model), "test")));
  for (const Frame& frame : drawFrames(3, 4, 300)) {
    EXPECT_EQ(trained.recognize(frame.image).decision_values,
              loaded.recognize(frame.image).decision_values);
  }
}

TEST(Recognizer, LimitsDecisionValuesButNotTheEvidence) {
  Model model = train({opener(drawFrames(3, 12))}, twoCueOptions()).model;
  Recognizer limited(std::make_shared<const Model>(parseModel(serializeModel(model), "test")));
  model.decision_limit = 0;
  Recognizer unlimited(std::make_shared<const Model>(std::move(model)));
  const cv::Mat image = drawRoom(1, 300);
  EXPECT_EQ(limited.recognize(image).evidence, unlimited.recognize(image).evidence);
  EXPECT_NE(limited.recognize(image).decision_values, unlimited.recognize(image).decision_values);
}

TEST(Recognizer, HoldsEvidenceAgainstTheThreshold) {
  Recognizer recognizer(modelOf(quickOptions()));
  const cv::Mat image = drawRoom(1, 300);
  recognizer.setUnknownThreshold(0);
  EXPECT_TRUE(recognizer.recognize(image).known);
  recognizer.setUnknownThreshold(1);
  const Recognition& unknown = recognizer.recognize(image);
  EXPECT_FALSE(unknown.known);
  EXPECT_GE(unknown.place, 0);
}

TEST(Recognizer, SaysWhyThereIsNoAnswer) {
  Recognizer recognizer(modelOf(quickOptions()));
  recognizer.recognize(drawRoom(0, 300));
  const Recognition& answer = recognizer.recognize(cv::Mat(2, 2, CV_8UC3, cv::Scalar::all(0)));
  EXPECT_EQ(answer.place, -1);
  EXPECT_FALSE(answer.known);
  EXPECT_NE(answer.reason, "");
  EXPECT_EQ(answer.confidence, 0);
  EXPECT_TRUE(answer.probabilities.isApproxToConstant(1.0 / 3));
}

TEST(Recognizer, AnswersImagesThatShowTooLittleWithTheReason) {
  TrainingOptions options = quickOptions();
  options.information.unknown_below = 0.01;
  const std::shared_ptr<const Model> model = modelOf(options);
  Recognizer recognizer(std::make_shared<const Model>(parseModel(serializeModel(*model), "test")));
  EXPECT_GE(recognizer.recognize(drawRoom(0, 300)).place, 0);
  cv::Mat wall(72, 96, CV_8UC3, cv::Scalar(200, 210, 220));
  cv::rectangle(wall, {0, 0, 20, 72}, cv::Scalar(170, 180, 190), cv::FILLED);  // a soft shadow
  cv::blur(wall, wall, {31, 31});
  for (const Recognition& answer : {recognizer.recognize(wall), recognizer.recognize(wall, 1.0)}) {
    EXPECT_EQ(answer.place, -1);
    EXPECT_FALSE(answer.known);
    EXPECT_NE(answer.reason.find("too little"), std::string::npos) << answer.reason;
  }
  EXPECT_GE(recognizer.recognize(drawRoom(0, 300), 1.1).place, 0);
  EXPECT_GE(Recognizer(modelOf(quickOptions())).recognize(wall).place, 0) << "off by default";
}

TEST(Recognizer, AnswersImagesOfOneColourWithTheReason) {
  Recognizer recognizer(modelOf(quickOptions()));
  const Recognition before = recognizer.recognize(drawRoom(0, 300), 1.0);
  const cv::Mat covered(72, 96, CV_8UC3, cv::Scalar(20, 10, 60));
  for (const Recognition& answer :
       {recognizer.recognize(covered), recognizer.recognize(covered, 1.1)}) {
    EXPECT_EQ(answer.place, -1);
    EXPECT_FALSE(answer.known);
    EXPECT_EQ(answer.reason, "the image shows nothing but one colour");
  }
  EXPECT_EQ(recognizer.recognize(drawRoom(0, 300), 1.2).decision_values, before.decision_values);
}

TEST(Recognizer, LeavesOutACueThatTheImageLacks) {
  // The second cue needs a taller image: the answer is that of the first cue alone.
  TrainingOptions options = twoCueOptions();
  std::get<CrfhOptions>(options.cues[0].feature).border = 5;
  Model model = train({opener(drawFrames(3, 12))}, options).model;
  model.cue_weights = {0.5, 0.5};
  const cv::Mat strip = drawRoom(1, 300)(cv::Rect(0, 20, 96, 24)).clone();

  Eigen::RowVectorXd both, first;
  Recognizer recognizer(std::make_shared<const Model>(parseModel(serializeModel(model), "test")));
  both = recognizer.recognize(strip).decision_values;
  model.cue_weights = {1, 0};
  Recognizer first_only(std::make_shared<const Model>(std::move(model)));
  first = first_only.recognize(strip).decision_values;
  EXPECT_EQ(both, first);
  EXPECT_NE(both, Eigen::RowVectorXd::Zero(3));
}

double rateAt(const std::shared_ptr<const Model>& model, double factor) {
  Recognizer recognizer(model);
  double right = 0;
  const std::vector<Frame> frames = drawFrames(3, 40, 5000);
  for (const Frame& frame : frames) {
    cv::Mat image;
    cv::resize(frame.image, image, {}, factor, factor,
               factor < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    const int place = recognizer.recognize(image).place;
    right += model->places[static_cast<std::size_t>(place)] == frame.place ? 1 : 0;
  }
  return right / static_cast<double>(frames.size());
}

TEST(Recognizer, KnowsRoomsFromImagesOfAnotherSize) {
  for (const char* descriptor : {"Lxx", "R"}) {
    TrainingOptions options = quickOptions();
    CrfhOptions& crfh = std::get<CrfhOptions>(options.cues[0].feature);
    crfh.descriptors = {"L", descriptor};
    crfh.scales = {4};  // detail that is still visible at half the size
    const std::shared_ptr<const Model> model = modelOf(options);
    const double rate = rateAt(model, 1);
    for (const double factor : {0.5, 0.75, 1.25, 2.0, 4.0}) {
      EXPECT_GE(rateAt(model, factor), rate - 0.03) << descriptor << " x " << factor;
    }
  }
}

TEST(Recognizer, ScalesWideImagesDown) {
  TrainingOptions options = quickOptions();
  options.image.max_width = 48;
  Recognizer recognizer(modelOf(options));
  const cv::Mat image = drawRoom(2, 300);
  cv::Mat half;
  cv::resize(image, half, cv::Size(48, 36), 0, 0, cv::INTER_AREA);
  const Eigen::RowVectorXd scaled = recognizer.recognize(image).decision_values;
  EXPECT_EQ(scaled, recognizer.recognize(half).decision_values);
}

TEST(Recognizer, TakesGreyImages) {
  Recognizer recognizer(modelOf(twoCueOptions()));
  cv::Mat grey;
  cv::cvtColor(drawRoom(1, 300), grey, cv::COLOR_BGR2GRAY);
  EXPECT_TRUE(recognizer.recognize(grey).probabilities.allFinite());
}

}  // namespace
}  // namespace place_recognition
