#include "recognition/recognizer/evidence_shift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// Returns a model of one cue whose held-out frames have familiarity `known` and decision values of
/// `lead` - 1 for their room and -1 for the others.
Model modelOf(int places, double lead, double known) {
  Model model;
  model.cue_weights = {1};
  model.decision_limit = 1;  // names the place only
  model.calibration.slope = 2;
  model.calibration.weights = {1, 10, -5};
  Eigen::MatrixXf decision_values = Eigen::MatrixXf::Constant(2 * places, places, -1);
  for (int i = 0; i < 2 * places; ++i) {
    decision_values(i, i % places) += static_cast<float>(lead);
    model.held_out.places.push_back(i % places);
  }
  for (int k = 0; k < places; ++k) model.places.push_back("room" + std::to_string(k));
  model.held_out.decision_values = {decision_values};
  model.held_out.familiarity = {Eigen::VectorXf::Constant(2 * places, static_cast<float>(known))};
  return model;
}

/// Frames of `places` rooms in turn, one per second, with familiarity `known` and decision values
/// of `lead` - 1 for the room and -1 for the others.
class Stream {
 public:
  explicit Stream(const Model& model)
      : calibration_(model.calibration),
        places_(static_cast<Eigen::Index>(model.places.size())),
        shift_(model) {}

  void show(int frames, double lead, double known, int places) {
    for (int i = 0; i < frames; ++i, ++stamp_) {
      Eigen::RowVectorXd decision_values = Eigen::RowVectorXd::Constant(places_, -1);
      const int place = static_cast<int>(stamp_) % places;
      decision_values[place] += lead;
      shift_.beginFrame(stamp_);
      shift_.add(Eigen::RowVectorXd::Unit(decision_values.size(), place), decision_values,
                 calibration_.logOdds(decision_values, known));
    }
  }

  double shift() const { return shift_.value(); }

 private:
  Calibration calibration_;
  Eigen::Index places_;
  EvidenceShift shift_;
  double stamp_ = 0;
};

TEST(EvidenceShift, FollowsTheFormula) {
  Stream stream(modelOf(4, 2, 0.9));
  EXPECT_EQ(stream.shift(), 0);
  stream.show(1, 2, 0.75, 4);  // one view, a fifth less for being of one place, as unlike as 1.5
  const double views = 1 / (1 + 1.0 / 5);
  const double ratio = (2 * 0.45 + views) / (2 + views);
  EXPECT_GT(ratio, 0.55);
  EXPECT_NEAR(stream.shift(), views * 1.5 / (1 + views), 1e-6);
}

TEST(EvidenceShift, CountsInPartWhereARoomStandsOutHalfAsClearly) {
  const Model model = modelOf(4, 2, 0.9);
  EvidenceShift shift(model);
  // The lead is 4 / sqrt(3) standard deviations in the held-out frames, and half of it here.
  const Eigen::RowVector4d learned(1, -1, -1, -1), now(1, (22 - std::sqrt(160)) / 18, 0, 0);
  shift.beginFrame(0);
  shift.add(Eigen::RowVector4d::Unit(0), now, model.calibration.logOdds(learned, 0.9) - 1.5);
  const double views = 1 / (1 + 1.0 / 5);
  const double ratio = (2 * 0.45 + views * 0.5) / (2 + views);
  EXPECT_NEAR(shift.value(), (ratio - 0.45) / 0.1 * views * 1.5 / (1 + views), 1e-6);
}

TEST(EvidenceShift, MakesUpForOtherLight) {
  // Familiarity has fallen by 0.2, two units of evidence; one room still stands out as clearly.
  Stream stream(modelOf(4, 2, 0.9));
  stream.show(60, 2, 0.7, 4);
  EXPECT_GT(stream.shift(), 1.8);
  EXPECT_LT(stream.shift(), 2);
  stream.show(1200, 2, 0.9, 4);  // the lamps are on again
  EXPECT_LT(stream.shift(), 0.2);
}

TEST(EvidenceShift, IsBoundedAndNeverLowersEvidence) {
  Stream far(modelOf(4, 2, 0.9));
  far.show(300, 2, 0.1, 4);
  EXPECT_EQ(far.shift(), 4);
  Stream near(modelOf(4, 2, 0.8));
  near.show(300, 2, 1, 4);
  EXPECT_EQ(near.shift(), 0);
}

TEST(EvidenceShift, StaysWhereNoRoomStandsOut) {
  const Model model = modelOf(4, 2, 0.9);
  EvidenceShift shift(model);
  const Eigen::RowVector4d decision_values(-0.5, -0.6, -0.9, -1);  // an unknown building
  for (int i = 0; i < 300; ++i) {
    shift.beginFrame(i);
    shift.add(model.calibration.probabilities(decision_values), decision_values,
              model.calibration.logOdds(decision_values, 0.6));
    EXPECT_EQ(shift.value(), 0);
  }
}

TEST(EvidenceShift, DoesNotFollowARobotThatStandsForAnHour) {
  // A whole hour in one place that looks unlike the training counts as five views.
  Stream stream(modelOf(4, 2, 0.9));
  stream.show(3600, 2, 0.6, 1);
  EXPECT_LT(stream.shift(), 3 * 5.0 / 6);
}

TEST(EvidenceShift, SurvivesDecisionValuesThatAreNotFinite) {
  const Model model = modelOf(4, 2, 0.9);
  EvidenceShift shift(model);
  for (const double decision_value : {1e200, std::numeric_limits<double>::infinity()}) {
    const Eigen::RowVector4d decision_values(decision_value, -decision_value, 0, 0);
    shift.beginFrame(0);
    shift.add(Eigen::RowVector4d(1, 0, 0, 0), decision_values, decision_value);
    EXPECT_TRUE(std::isfinite(shift.value())) << decision_value;
  }
}

TEST(EvidenceShift, NeedsThreePlacesAndHeldOutFrames) {
  Stream two(modelOf(2, 2, 0.9));
  two.show(60, 2, 0.5, 2);
  EXPECT_EQ(two.shift(), 0);
  Model old = modelOf(4, 2, 0.9);
  old.held_out = {};
  Stream without(old);
  without.show(60, 2, 0.5, 4);
  EXPECT_EQ(without.shift(), 0);
}

TEST(EvidenceShift, HoldsForStreamsNotForImagesByThemselves) {
  const auto model = std::make_shared<const Model>(
      train(std::vector<RecordingOpener>{opener(drawFrames(3, 20))}, quickOptions()).model);
  std::vector<cv::Mat> dimmed;
  for (int room = 0; room < 3; ++room) {
    for (unsigned i = 0; i < 20; ++i) {
      cv::Mat blurred;
      cv::GaussianBlur(drawRoom(room, 500 + i), blurred, cv::Size(0, 0), 1);
      dimmed.push_back(blurred);
    }
  }
  Recognizer stream(model);
  Recognizer alone(model);
  double stamp = 0;
  for (const cv::Mat& image : dimmed) stream.recognize(image, stamp++);
  const double shift = stream.evidenceShift();
  ASSERT_GT(shift, 0.1);
  for (const cv::Mat& image : dimmed) alone.recognize(image);
  EXPECT_EQ(alone.evidenceShift(), 0);
  stream.forgetStream();
  EXPECT_EQ(stream.evidenceShift(), 0);
}

}  // namespace
}  // namespace place_recognition
