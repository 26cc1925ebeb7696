#include "recognition/training/learned_before.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "recognition/drawn_recording.h"
#include "recognition/training/combination.h"
#include "recognition/training/model_answers.h"
#include "recognition/training/remembered_samples.h"

namespace place_recognition {
namespace {

/// Returns the smallest lead of a frame's own room over the others that `frames` ask for.
double requestedLead(const Model& model, const std::vector<Frame>& frames) {
  const Samples added = collectSamplesFor(model, {opener(frames)}, model.options, 1, {}, 1);
  const Eigen::MatrixXd before =
      combine(modelAnswers(model, added.features), model.cue_weights, 0).decision_values;
  const Samples samples = joinSamples(rememberedSamples(model), added);
  const Eigen::MatrixXd changes = learnedBefore(model, samples).changes.bottomRows(before.rows());
  double lead = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < before.rows(); ++i) {
    Eigen::RowVectorXd values = before.row(i) + changes.row(i);
    const int own = samples.origins[samples.remembered + static_cast<std::size_t>(i)].place;
    const double value = std::exchange(values[own], -std::numeric_limits<double>::infinity());
    lead = std::min(lead, value - values.maxCoeff());
  }
  return lead;
}

// A larger lead would take views from rooms that the new images do not show.
TEST(LearnedBefore, AsksForAMarginOfTwoOnlyIfAllRoomsAreShown) {
  const Model model = train({opener(drawFrames(4, 30))}, twoCueOptions()).model;
  std::vector<Frame> all = drawFrames(4, 15, 900);
  for (Frame& frame : all) frame.image = frame.image * 0.5;
  std::vector<Frame> some;
  for (const Frame& frame : all) {
    if (frame.place != "room3") some.push_back(frame);
  }
  EXPECT_NEAR(requestedLead(model, all), 2, 1e-6);
  EXPECT_NEAR(requestedLead(model, some), std::min(1.0, std::log(9) / model.calibration.slope),
              1e-6);
}

}  // namespace
}  // namespace place_recognition
