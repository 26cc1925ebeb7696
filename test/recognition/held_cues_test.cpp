// Cues that are not computed for every image: those of embeddings at ~embedding_rate, and those for
// which there is no time.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/frames/cue_extraction.h"
#include "recognition/network_options.h"

namespace place_recognition {
namespace {

std::shared_ptr<const Model> modelWithNetwork() {
  Model model = train({opener(drawFrames(3, 12))}, networkOptions()).model;
  model.cue_weights = {0.25, 0.75};
  return std::make_shared<const Model>(std::move(model));
}

/// Returns the limited decision values of one cue for an image.
Eigen::RowVectorXd decisionValues(const Model& model, std::size_t cue, const cv::Mat& image) {
  std::vector<Feature> features;
  CueExtraction(model).extract(image, features);
  Eigen::VectorXd kernel_values;
  Eigen::RowVectorXd decision_values;
  model.classifiers[cue].decisionValues(features[cue], kernel_values, decision_values);
  return model.decision_limit * (decision_values / model.decision_limit).array().tanh();
}

TEST(HeldCues, HoldsDecisionValuesOfEmbeddingsAndLetsThemAge) {
  const std::shared_ptr<const Model> model = modelWithNetwork();
  Recognizer recognizer(model);
  recognizer.setEmbeddingRate(1);
  recognizer.setDecorrelationTime(0.4);
  const cv::Mat first = drawRoom(0, 300);
  const double start = 100;
  recognizer.recognize(first, start);
  for (const double age : {0.1, 0.3, 0.45}) {
    const cv::Mat image = drawRoom(1, 400);
    recognizer.recognize(drawRoom(2, 500));  // a single image does not affect the stream
    const double held = 0.75 * std::exp(-age / 0.4);
    const Eigen::RowVectorXd expected =
        (0.25 * decisionValues(*model, 0, image) + held * decisionValues(*model, 1, first)) /
        (0.25 + held);
    const Eigen::RowVectorXd decision_values =
        recognizer.recognize(image, start + age).decision_values;
    EXPECT_TRUE(decision_values.isApprox(expected, 1e-12)) << decision_values << " at " << age;
  }
  // Due again, and after time jumps back.
  for (const double stamp : {start + 1, start - 50}) {
    const cv::Mat image = drawRoom(1, 600);
    EXPECT_EQ(recognizer.recognize(image, stamp).decision_values,
              recognizer.recognize(image).decision_values);
    recognizer.recognize(image, stamp + 0.1);
  }
}

TEST(HeldCues, HoldsDecisionValuesOfCuesForWhichThereIsNoTime) {
  Model two_cues = train({opener(drawFrames(3, 12))}, twoCueOptions()).model;
  two_cues.cue_weights = {0.25, 0.75};
  const auto model = std::make_shared<const Model>(std::move(two_cues));
  Recognizer recognizer(model);
  recognizer.setDecorrelationTime(0.4);
  const cv::Mat first = drawRoom(0, 300);
  EXPECT_TRUE(recognizer.recognize(first, 100).held.empty());
  std::array<cv::Mat, 2> last{first, first};  // the image that each cue was computed from
  std::array<double, 2> at{0, 0};             // and its age
  for (const double age : {0.1, 0.3}) {
    const cv::Mat image = drawRoom(1, 400);
    const Recognition& answer = recognizer.recognize(image, 100 + age, 0);
    ASSERT_EQ(answer.held.size(), 1u);
    const std::size_t held = answer.held[0];  // the cue that took longer
    const std::size_t computed = 1 - held;
    const double weight = model->cue_weights[computed];
    const double held_weight = model->cue_weights[held] * std::exp((at[held] - age) / 0.4);
    const Eigen::RowVectorXd expected = (weight * decisionValues(*model, computed, image) +
                                         held_weight * decisionValues(*model, held, last[held])) /
                                        (weight + held_weight);
    EXPECT_TRUE(answer.decision_values.isApprox(expected, 1e-12))
        << answer.decision_values << " at " << age;
    last[computed] = image;  // next time, the other cue may have taken longer
    at[computed] = age;
  }
  // After a jump back in time and in a new stream, earlier decision values are not used.
  const cv::Mat image = drawRoom(2, 500);
  for (const double stamp : {50.0, 200.0}) {
    const Recognition& answer = recognizer.recognize(image, stamp, 0);
    ASSERT_EQ(answer.held.size(), 1u);
    EXPECT_TRUE(
        answer.decision_values.isApprox(decisionValues(*model, 1 - answer.held[0], image), 1e-12));
    recognizer.recognize(first, stamp + 0.1);
    recognizer.forgetStream();
  }
  // Nor when time reaches their stamps again.
  recognizer.recognize(first, 300);
  for (const double stamp : {250.0, 300.1}) {
    const Recognition& answer = recognizer.recognize(image, stamp, 0);
    ASSERT_EQ(answer.held.size(), 1u);
    EXPECT_TRUE(
        answer.decision_values.isApprox(decisionValues(*model, 1 - answer.held[0], image), 1e-12));
  }
}

TEST(HeldCues, HoldsAllCuesOfANetworkOrNone) {
  TrainingOptions options = networkOptions();
  options.cues.push_back(options.cues[1]);
  options.cues[2].name = "layout";
  std::get<EmbeddingOptions>(options.cues[2].feature).columns = 3;
  Model trained = train({opener(drawFrames(3, 12))}, options).model;
  trained.cue_weights = {0.2, 0.4, 0.4};
  const auto model = std::make_shared<const Model>(std::move(trained));
  Recognizer recognizer(model);
  const cv::Mat image = drawRoom(0, 300);
  EXPECT_TRUE(recognizer.recognize(image, 100).held.empty());
  const Eigen::RowVectorXd expected = 0.2 * decisionValues(*model, 0, image) +
                                      0.4 * decisionValues(*model, 1, image) +
                                      0.4 * decisionValues(*model, 2, image);
  EXPECT_TRUE(recognizer.recognize(image, 101).decision_values.isApprox(expected, 1e-12));
  for (const double stamp : {102.0, 103.0, 104.0}) {
    const std::vector<std::size_t> held = recognizer.recognize(drawRoom(1, 400), stamp, 0).held;
    EXPECT_TRUE(held == std::vector<std::size_t>{0} || held == std::vector<std::size_t>({1, 2}));
  }
}

TEST(HeldCues, ComputesOneCueThatTheImageHasWhateverTheTime) {
  TrainingOptions options = twoCueOptions();
  std::get<CrfhOptions>(options.cues[0].feature).border = 5;
  Model two_cues = train({opener(drawFrames(3, 12))}, options).model;
  two_cues.cue_weights = {0.5, 0.5};
  Recognizer recognizer(std::make_shared<const Model>(std::move(two_cues)));
  const cv::Mat strip = drawRoom(1, 300)(cv::Rect(0, 20, 96, 24)).clone();  // lacks the second
  for (const double stamp : {1.0, 1.1, 1.2}) {
    EXPECT_GE(recognizer.recognize(strip, stamp, 0).place, 0);
  }
}

TEST(HeldCues, WithoutALimitEmbeddingsAreComputedForEveryFrame) {
  const std::shared_ptr<const Model> model = modelWithNetwork();
  Recognizer recognizer(model);
  for (unsigned i = 0; i < 5; ++i) {
    const cv::Mat image = drawRoom(static_cast<int>(i % 3), 300 + i);
    EXPECT_EQ(recognizer.recognize(image, 0.01 * i).decision_values,
              recognizer.recognize(image).decision_values);
  }
}

TEST(HeldCues, DoesNotExtractCuesThatDoNotCount) {
  Model model = train({opener(drawFrames(3, 12))}, twoCueOptions()).model;
  model.cue_weights = {0, 1};
  std::vector<Feature> features;
  EXPECT_TRUE(CueExtraction(model).extract(drawRoom(1, 300), features));
  ASSERT_EQ(features.size(), 2u);
  EXPECT_TRUE(isMissing(features[0]));
  EXPECT_FALSE(isMissing(features[1]));
}

/// Returns the fraction of correct answers to new frames of three drawn rooms, scaled by `factor`.

}  // namespace
}  // namespace place_recognition
