#include "place_recognition/recalibration.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "learning/classifier_parts.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/frames/light.h"

namespace place_recognition {
namespace {

Model drawnModel(int rooms = 3) {
  return train({opener(drawFrames(rooms, 30))}, twoCueOptions()).model;
}

TEST(Recalibrate, FitsSlopeAndThresholdToAnotherRun) {
  Model model = drawnModel();
  model.calibration.slope = 100;            // far too confident
  model.calibration.weights.offset = -1e6;  // but never above the threshold
  const Recalibration result = recalibrate(std::move(model), {opener(drawFrames(3, 40, 800))});
  EXPECT_EQ(result.images, 120u);
  EXPECT_GT(result.before.unknown, 0.9);
  EXPECT_NEAR(result.after.unknown, 0.05, 0.06);
  EXPECT_LT(result.model.calibration.slope, 100);
  EXPECT_LE(result.after.calibration_error, result.before.calibration_error + 0.05);
  EXPECT_EQ(result.model.validatedPlaces(), result.model.places);
}

TEST(Recalibrate, LeavesAsManyFramesOfAStreamUnknownAsAskedFor) {
  // A dark stretch, for which the recognizer compensates over time.
  std::vector<Frame> frames = drawFrames(3, 100, 800);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i % 100 >= 70) frames[i].image = inLight(frames[i].image, {0.5, 0.5, 0.5});
  }
  Recalibration result = recalibrate(drawnModel(), {opener(frames)});
  Recognizer recognizer(std::make_shared<const Model>(std::move(result.model)));
  double unknown = 0;
  for (const Frame& frame : frames) {
    unknown += recognizer.recognize(frame.image, frame.stamp).known ? 0 : 1;
  }
  EXPECT_NEAR(unknown / static_cast<double>(frames.size()), 0.05, 0.01);
}

TEST(Recalibrate, LeavesTheMachinesAsTheyAre) {
  const Model before = drawnModel();
  const Recalibration result = recalibrate(drawnModel(), {opener(drawFrames(3, 20, 800))});
  for (std::size_t c = 0; c < before.classifiers.size(); ++c) {
    for (const Feature& feature :
         ClassifierParts::of(before.classifiers[c]).support_set.vectors()) {
      Eigen::VectorXd scratch;
      Eigen::RowVectorXd decision_values, values_after;
      before.classifiers[c].decisionValues(feature, scratch, decision_values);
      result.model.classifiers[c].decisionValues(feature, scratch, values_after);
      EXPECT_EQ(decision_values, values_after);
    }
  }
}

std::size_t warningsOfLearnedRuns(Model model, const RecordingOpener& recording) {
  const Recalibration result = recalibrate(std::move(model), {recording});
  for (const std::string& warning : result.warnings) {
    EXPECT_NE(warning.find("was trained on"), std::string::npos) << warning;
  }
  return result.warnings.size();
}

TEST(Recalibrate, WarnsOfARunThatWasLearnedWhereverItLies) {
  EXPECT_EQ(warningsOfLearnedRuns(drawnModel(), opener(drawFrames(3, 20), "copies/of_it")), 1u);
  EXPECT_EQ(warningsOfLearnedRuns(drawnModel(), opener(drawFrames(3, 20, 800), "drawn")), 0u);
  Model earlier = drawnModel();
  earlier.provenance.sketches.clear();  // as in a file of an earlier version
  EXPECT_EQ(warningsOfLearnedRuns(parseModel(serializeModel(earlier), "drawn"),
                                  opener(drawFrames(3, 20), "drawn")),
            0u);
}

TEST(Recalibrate, WarnsOfARunOfWhichMostImagesWereLearned) {
  std::vector<Frame> frames = drawFrames(3, 20), other = drawFrames(3, 20, 800);
  for (int i = 0; i < 2; ++i) {  // a covered lens
    frames[i].image = other[i].image = cv::Mat(72, 96, CV_8UC3, cv::Scalar::all(0));
  }
  const std::string model = serializeModel(train({opener(frames)}, twoCueOptions()).model);
  const auto is_warned = [&model](const std::vector<Frame>& run) {
    const Recalibration result = recalibrate(parseModel(model, "drawn"), {opener(run)});
    return std::any_of(result.warnings.begin(), result.warnings.end(), [](const auto& warning) {
      return warning.find("was trained on") != std::string::npos;
    });
  };
  EXPECT_TRUE(is_warned({frames.begin() + 15, frames.begin() + 45})) << "a part of it";
  EXPECT_FALSE(is_warned(other)) << "the first images are alike";
  other.insert(other.begin() + 20, frames.begin() + 2, frames.begin() + 10);
  EXPECT_FALSE(is_warned(other)) << "a few of its images";
  frames.insert(frames.begin() + 20, other[5]);
  EXPECT_TRUE(is_warned(frames)) << "a folder with one more image";
}

TEST(Recalibrate, LeavesPlacesOutThatTheModelDoesNotKnow) {
  const Recalibration result =
      recalibrate(drawnModel(2), {opener(drawFrames(3, 20, 800), "tuesday")});
  EXPECT_EQ(result.images, 40u);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("'room2'"), std::string::npos);
  std::vector<Frame> elsewhere = drawFrames(1, 20);
  for (Frame& frame : elsewhere) frame.place = "elsewhere";
  EXPECT_THROW(recalibrate(drawnModel(2), {opener(elsewhere)}), Error);
}

std::vector<Frame> inDimLight(std::vector<Frame> frames) {
  for (Frame& frame : frames) frame.image = inLight(frame.image, {0.5, 0.6, 0.7});
  return frames;
}

double rateInDimLight(const std::string& normalize) {
  TrainingOptions options = twoCueOptions();
  options.cues.erase(options.cues.begin());  // colour alone
  options.cues[0].normalize = normalize;
  Model model = train({opener(drawFrames(3, 30))}, options).model;
  return recalibrate(std::move(model), {opener(inDimLight(drawFrames(3, 40, 800)))})
      .before.average_rate;
}

TEST(Recalibrate, HoldsTheLightOfARunAgainstTheTrainingByItsLabels) {
  EXPECT_LT(rateInDimLight("none"), 0.7);
  EXPECT_GT(rateInDimLight("run"), 0.95);
}

TEST(Recalibrate, TreatsThePartsOfARecordingLikeTheWhole) {
  TrainingOptions options = twoCueOptions();
  options.cues[1].normalize = "run";
  const std::string file = serializeModel(train({opener(drawFrames(3, 30))}, options).model);
  const std::vector<Frame> whole = inDimLight(drawFrames(3, 40, 800));
  const auto calibratedOn = [&](const std::vector<RecordingOpener>& recordings) {
    return serializeModel(recalibrate(parseModel(file, "drawn"), recordings).model);
  };
  const std::string expected = calibratedOn({opener(whole)});
  EXPECT_EQ(calibratedOn(openersOfParts(whole, {50, 90})), expected);
}

TEST(TrainIncrementally, KeepsTheLightOfTheTraining) {
  TrainingOptions options = twoCueOptions();
  for (CueOptions& cue : options.cues) cue.normalize = "run";
  const Model model = train({opener(drawFrames(3, 30))}, options).model;
  const Model after =
      trainIncrementally(model, {opener(inDimLight(drawFrames(3, 30, 800)))}, {0}).model;
  EXPECT_LT((after.colours.means - model.colours.means).cwiseAbs().maxCoeff(), 0.1);
}

}  // namespace
}  // namespace place_recognition
