#include "place_recognition/fixed_lag_smoother.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "place_recognition/error.h"
#include "recognition/over_time/transition_model.h"

namespace place_recognition {
namespace {

constexpr int kStates = 4;  // three rooms and 'unknown'
constexpr double kPeriod = 0.25;

/// Rooms 0 - 1 - 2 in a row.
Adjacency row() {
  Adjacency adjacency(3);
  adjacency.join(0, 1);
  adjacency.join(1, 2);
  return adjacency;
}

TemporalFilter filterOf() {
  Model model;
  model.places = {"office", "corridor", "kitchen"};
  model.unknown_threshold = 0.5;
  return TemporalFilter(model, row(), {});
}

Recognition seen(int place, double probability = 0.8, double evidence = 0.9) {
  Recognition frame;
  frame.place = place;
  frame.probabilities.setConstant(3, (1 - probability) / 2);
  frame.probabilities[place] = probability;
  frame.evidence = evidence;
  return frame;
}

std::vector<FilteredAnswer> readyOnes(FixedLagSmoother& smoother) {
  std::vector<FilteredAnswer> answers;
  while (smoother.ready()) answers.push_back(smoother.next());
  return answers;
}

/// Returns the answers to frames that come every kPeriod from stamp 100, up to the last one.
std::vector<FilteredAnswer> smoothed(const std::vector<Recognition>& frames, double lag) {
  TemporalFilter filter = filterOf();
  FixedLagSmoother smoother(row(), {}, lag);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    filter.update(100 + kPeriod * static_cast<double>(i), frames[i]);
    smoother.add(filter);
  }
  smoother.finish();
  return readyOnes(smoother);
}

/// Returns the probabilities of the state at frame `index` given all `frames`, by summing over all
/// sequences of states.
Eigen::RowVectorXd bySummation(const std::vector<Recognition>& frames, std::size_t index) {
  const TemporalFilterOptions options;
  TransitionModel chain(row(), options.unknown_share, options.jump_share);
  Eigen::MatrixXd move(kStates, kStates);
  for (int state = 0; state < kStates; ++state) {
    Eigen::RowVectorXd belief = Eigen::RowVectorXd::Unit(kStates, state);
    chain.advance(kPeriod / options.dwell_time, belief);
    move.row(state) = belief;
  }
  TemporalFilter filter = filterOf();
  Eigen::RowVectorXd belief = chain.prior();
  std::vector<Eigen::RowVectorXd> likelihoods;  // factor by which each frame multiplied the belief
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i > 0) belief *= move;
    filter.update(100 + kPeriod * static_cast<double>(i), frames[i]);
    likelihoods.push_back(filter.answer().probabilities.cwiseQuotient(belief));
    belief = filter.answer().probabilities;
  }
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(kStates);
  const auto paths = static_cast<std::size_t>(std::pow(kStates, frames.size()));
  for (std::size_t path = 0; path < paths; ++path) {
    double probability = 1;
    int before = -1, there = -1;
    for (std::size_t i = 0, digits = path; i < frames.size(); ++i, digits /= kStates) {
      const int state = static_cast<int>(digits % kStates);
      probability *= (i == 0 ? chain.prior()[state] : move(before, state)) * likelihoods[i][state];
      if (i == index) there = state;
      before = state;
    }
    sums[there] += probability;
  }
  return sums / sums.sum();
}

TEST(FixedLagSmoother, IsTheForwardBackwardAlgorithm) {
  const std::vector<Recognition> frames{seen(0), seen(0, 0.5), seen(2, 0.5, 0.2), seen(1), seen(1)};
  const std::vector<FilteredAnswer> answers = smoothed(frames, 10);
  ASSERT_EQ(answers.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::RowVectorXd expected = bySummation(frames, i);
    EXPECT_TRUE(answers[i].probabilities.isApprox(expected, 1e-9))
        << i << ": " << answers[i].probabilities << " instead of " << expected;
  }
}

TEST(FixedLagSmoother, LooksNoFurtherThanItsLag) {
  const std::vector<Recognition> frames{seen(0), seen(0, 0.5), seen(1, 0.5), seen(1), seen(2)};
  const std::vector<FilteredAnswer> answers = smoothed(frames, 2 * kPeriod);
  for (std::size_t i = 0; i + 2 < frames.size(); ++i) {
    const std::vector<Recognition> window(frames.begin(), frames.begin() + i + 3);
    EXPECT_TRUE(answers[i].probabilities.isApprox(bySummation(window, i), 1e-9)) << i;
  }
}

TEST(FixedLagSmoother, WithoutALagItIsTheFilter) {
  const std::vector<Recognition> frames{seen(0), seen(1), seen(1), seen(2, 0.5, 0.1), seen(1)};
  const std::vector<FilteredAnswer> answers = smoothed(frames, 0);
  TemporalFilter filter = filterOf();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    filter.update(100 + kPeriod * static_cast<double>(i), frames[i]);
    EXPECT_TRUE(answers[i].probabilities.isApprox(filter.answer().probabilities, 1e-12)) << i;
  }
}

TEST(FixedLagSmoother, KnowsHowItWentOn) {
  // Two frames of another room are errors if the first room comes back; otherwise they begin a
  // change of room.
  std::vector<Recognition> frames(20, seen(0));
  frames[10] = frames[11] = seen(1);
  for (const FilteredAnswer& answer : smoothed(frames, 1)) EXPECT_EQ(answer.place, 0);

  for (std::size_t i = 12; i < frames.size(); ++i) frames[i] = seen(1);
  const std::vector<FilteredAnswer> answers = smoothed(frames, 1);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(answers[i].place, i < 10 ? 0 : 1) << i;
    EXPECT_EQ(answers[i].changed, i == 0 || i == 10) << i;
  }
}

TEST(FixedLagSmoother, EveryFrameIsAnsweredOnceWhenItsLagIsOver) {
  TemporalFilter filter = filterOf();
  FixedLagSmoother smoother(row(), {}, 1);
  std::size_t answered = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    filter.update(kPeriod * static_cast<double>(i), seen(0));
    smoother.add(filter);
    answered += readyOnes(smoother).size();
    EXPECT_EQ(answered, i < 4 ? 0 : i - 4);
  }
  smoother.finish();
  EXPECT_EQ(answered + readyOnes(smoother).size(), 40u);
  EXPECT_FALSE(smoother.ready());
}

TEST(FixedLagSmoother, DoesNotWaitWhereTheFilterRestarts) {
  TemporalFilter filter = filterOf();
  FixedLagSmoother smoother(row(), {}, 1);
  for (const double stamp : {100.0, 100.1, 50.0}) {  // back in time, as in a looped bag
    filter.update(stamp, seen(stamp < 100 ? 2 : 0));
    smoother.add(filter);
  }
  const std::vector<FilteredAnswer> answers = readyOnes(smoother);
  ASSERT_EQ(answers.size(), 2u);
  for (const FilteredAnswer& answer : answers) EXPECT_EQ(answer.place, 0);
  smoother.finish();
  EXPECT_EQ(readyOnes(smoother).front().place, 2);
}

TEST(FixedLagSmoother, HoldsNoMoreThanItsMostFramesWhereStampsStandStill) {
  TemporalFilter filter = filterOf();
  FixedLagSmoother smoother(row(), {}, 1);
  std::size_t held = 0;
  for (std::size_t i = 0; i < FixedLagSmoother::kMaxFrames + 50; ++i, ++held) {
    filter.update(100, seen(0));
    smoother.add(filter);
    held -= readyOnes(smoother).size();
    ASSERT_LT(held, FixedLagSmoother::kMaxFrames);
  }
}

TEST(FixedLagSmoother, AFrameWithoutFeaturesIsAnsweredByItsNeighbours) {
  Recognition nothing = seen(2, 1.0 / 3, 0);
  nothing.place = -1;
  const std::vector<FilteredAnswer> answers = smoothed({seen(0), nothing, seen(0), seen(0)}, 1);
  EXPECT_EQ(answers[1].place, 0);
}

TEST(FixedLagSmoother, OptionsOutOfRangeAreRefused) {
  TemporalFilterOptions options;
  options.dwell_time = 0;
  EXPECT_THROW(FixedLagSmoother(row(), options, 1), Error);
  EXPECT_THROW(FixedLagSmoother(row(), {}, -1), Error);
  EXPECT_THROW(FixedLagSmoother(row(), {}, std::numeric_limits<double>::quiet_NaN()), Error);
}

}  // namespace
}  // namespace place_recognition
