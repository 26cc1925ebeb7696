// Several cameras on one robot, combined over time.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "place_recognition/temporal_filter.h"
#include "recognition/over_time/transition_model.h"

namespace place_recognition {
namespace {

constexpr double kThreshold = 0.5;

Recognition seen(int place, double probability = 0.7) {
  Recognition frame;
  frame.probabilities.setConstant(3, (1 - probability) / 2);
  frame.probabilities[place] = frame.confidence = probability;
  frame.place = place;
  frame.evidence = 0.9;
  frame.known = true;
  return frame;
}

Model threeRooms() {
  Model model;
  model.places = {"hall", "kitchen", "lab"};
  model.provenance.place_images = {50, 50, 50};
  model.unknown_threshold = kThreshold;
  return model;
}

TemporalFilter filterOf(int cameras, double correlation) {
  static const Model model = threeRooms();
  Eigen::MatrixXd all = Eigen::MatrixXd::Constant(cameras, cameras, correlation);
  all.diagonal().setOnes();
  return {
      std::vector<const Model*>(static_cast<std::size_t>(cameras), &model), all, Adjacency(3), {}};
}

/// A frame and the weight of its evidence.
struct Shown {
  double stamp;
  std::size_t camera;
  int place;
  double weight;
};

/// Returns the belief after frames within one second, by the equations.
Eigen::RowVectorXd expected(const std::vector<Shown>& frames) {
  const TemporalFilterOptions options;
  TransitionModel chain(Adjacency(3), options.unknown_share, options.jump_share);
  Eigen::RowVectorXd belief = chain.prior();
  double now = frames.front().stamp;
  for (const Shown& frame : frames) {
    const double elapsed = std::max(0.0, frame.stamp - now);
    now += elapsed;
    if (elapsed > 0) chain.advance(elapsed / options.dwell_time, belief);
    const auto tempered = [](double ratio) { return 0.9 * ratio + 0.1; };
    for (int state = 0; state < 4; ++state) {
      const double room = tempered(3 * (state == frame.place ? 0.7 : 0.15)) / tempered(3 * 0.7);
      const double likelihood = state == 3 ? tempered(0.1 / 0.5) : tempered(0.9 / 0.5) * room;
      belief[state] *= std::pow(likelihood, frame.weight);
    }
    belief /= belief.sum();
  }
  return belief;
}

TEST(TemporalFilterOfCameras, CountsEachByItsOwnTimeAndWhatTheOthersDoNotSay) {
  // Decorrelation time 0.2 s; the second frame of a moment shares 0.25 of its evidence.
  const std::vector<Shown> frames{{10, 0, 0, 1},
                                  {10, 1, 1, 1 / 1.25},
                                  {10.1, 0, 0, 0.5 / 1.25},
                                  {10.13, 1, 0, 0.65 / 1.25},
                                  {10.4, 1, 2, 1 / 1.25},
                                  {10.4, 0, 0, 1 / 1.25}};
  TemporalFilter filter = filterOf(2, 0.25);
  FilteredAnswer last;
  for (const Shown& frame : frames) {
    last = filter.update(frame.stamp, seen(frame.place), std::nullopt, frame.camera);
  }
  EXPECT_TRUE(last.probabilities.isApprox(expected(frames), 1e-9)) << last.probabilities;
}

TEST(TemporalFilterOfCameras, CamerasThatAlwaysErrTogetherCountAsOne) {
  TemporalFilter one = filterOf(1, 1), three = filterOf(3, 1);
  // Weighted by their fractions, three frames per moment carry the evidence of one.
  const auto show = [&](double stamp) {
    one.update(stamp, seen(0));
    for (const std::size_t camera : {0, 1, 2}) three.update(stamp, seen(0), std::nullopt, camera);
  };
  for (int i = 0; i <= 10; ++i) show(0.1 * i);
  const double odds[2] = {one.answer().probabilities[0] / one.answer().probabilities[1],
                          three.answer().probabilities[0] / three.answer().probabilities[1]};
  EXPECT_NEAR(odds[1] / odds[0], 1, 0.05);
}

/// Returns the evidence of an update for the first room against the second, in log odds. `before`:
/// the belief before it; `changes`: the mean number of changes of room since.
double spoken(Eigen::RowVectorXd before, double changes, const Eigen::RowVectorXd& after) {
  const TemporalFilterOptions options;
  TransitionModel(Adjacency(3), options.unknown_share, options.jump_share).advance(changes, before);
  return std::log(after[0] / before[0]) - std::log(after[1] / before[1]);
}

TEST(TemporalFilterOfCameras, OneThatIsSilentOrSaysNothingStopsCounting) {
  const TemporalFilterOptions options;
  const auto lastWeight = [&](double silence, bool blind) {
    TemporalFilter filter = filterOf(2, 1);
    filter.update(0, seen(0));
    filter.update(0, seen(0), std::nullopt, 1);
    Recognition nothing = seen(0);
    nothing.place = -1;
    for (double t = 0.2; t < silence - 0.1; t += 0.2) {
      filter.update(t, nothing);
      if (blind) filter.update(t, nothing, std::nullopt, 1);
    }
    // Little evidence for the rooms, so that the odds can be distinguished.
    const Eigen::RowVectorXd before = filter.update(silence - 0.1, nothing).probabilities;
    return spoken(before, 0.1 / options.dwell_time, filter.update(silence, seen(0)).probabilities);
  };
  const double together = lastWeight(0.8, false);
  const double alone = lastWeight(0.8 + options.camera_gap, false);
  EXPECT_NEAR(alone / together, 2, 1e-6);
  EXPECT_NEAR(lastWeight(0.8 + options.camera_gap, true) / together, 2, 1e-6);
}

TEST(TemporalFilterOfCameras, AFrameThatComesAfterALaterOneOfAnotherCounts) {
  const std::vector<Shown> frames{{10, 0, 0, 1}, {9.9, 1, 1, 1 / 1.5}, {10.2, 0, 0, 1 / 1.5}};
  TemporalFilter filter = filterOf(2, 0.5);
  for (const Shown& frame : frames) {
    filter.update(frame.stamp, seen(frame.place), std::nullopt, frame.camera);
  }
  EXPECT_TRUE(filter.answer().probabilities.isApprox(expected(frames), 1e-9));
  // Before the last one of its own camera, or as far from all as after a pause: restarts.
  const Eigen::RowVectorXd anew = filterOf(2, 0.5).update(0, seen(1)).probabilities;
  EXPECT_EQ(filter.update(10.1, seen(1)).probabilities, anew);
  EXPECT_EQ(filter.update(-10, seen(1), std::nullopt, 1).probabilities, anew);
}

TEST(TemporalFilterOfCameras, MotionSinceTheLastFrameIsNewToAll) {
  TemporalFilter filter = filterOf(2, 0);
  filter.update(0, seen(0));
  filter.update(0, seen(0), std::nullopt, 1);
  double stamp = 0;
  const auto weightOf = [&](std::size_t camera, double metres) {
    const Eigen::RowVectorXd before = filter.answer().probabilities;
    filter.update(stamp += 0.1, seen(0), Motion{metres, 0}, camera);
    return spoken(before, metres / TemporalFilterOptions().dwell_distance,
                  filter.answer().probabilities);
  };
  const double full = weightOf(0, 1);
  EXPECT_NEAR(weightOf(1, 0), full, 1e-6);  // for the metre before the other camera's frame
  EXPECT_NEAR(weightOf(1, 0.05), full / 2, 1e-6);
  EXPECT_NEAR(weightOf(0, 0), full / 2, 1e-6);
}

TEST(TemporalFilterOfCameras, EachHasTheThresholdAndSharesOfItsModel) {
  Model other = threeRooms();
  other.provenance.place_images = {5, 50, 500};
  other.unknown_threshold = 0.8;
  const Model model = threeRooms();
  TemporalFilter both({&model, &other}, Eigen::Matrix2d::Identity(), Adjacency(3), {});
  TemporalFilter first(model, Adjacency(3), {}), second(other, Adjacency(3), {});
  // From equal beliefs in all rooms, the likelihoods can be derived.
  EXPECT_EQ(both.update(0, seen(0), std::nullopt, 0).probabilities,
            first.update(0, seen(0)).probabilities);
  both.reset();
  EXPECT_EQ(both.update(0, seen(1), std::nullopt, 1).probabilities,
            second.update(0, seen(1)).probabilities);
}

}  // namespace
}  // namespace place_recognition
