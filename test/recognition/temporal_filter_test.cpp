#include "place_recognition/temporal_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "error_of.h"
#include "recognition/over_time/transition_model.h"

namespace place_recognition {
namespace {

constexpr double kThreshold = 0.5;

Recognition seen(std::vector<double> probabilities, double evidence = 0.9) {
  Recognition frame;
  frame.probabilities = Eigen::Map<Eigen::RowVectorXd>(
      probabilities.data(), static_cast<Eigen::Index>(probabilities.size()));
  frame.confidence = frame.probabilities.maxCoeff(&frame.place);
  frame.evidence = evidence;
  frame.known = evidence >= kThreshold;
  return frame;
}

/// Returns the probabilities of four rooms: 0.7 for `place`, 0.1 for each other one.
Recognition seen(int place, double evidence = 0.9) {
  std::vector<double> probabilities(4, 0.1);
  probabilities[place] = 0.7;
  return seen(probabilities, evidence);
}

/// Returns a model with the fields that the filter uses.
Model modelOf(const std::vector<std::uint64_t>& place_images) {
  Model model;
  model.places.assign(place_images.size(), "room");
  model.provenance.place_images = place_images;
  model.unknown_threshold = kThreshold;
  return model;
}

Recognition nothingSeen() {
  Recognition frame = seen({0.25, 0.25, 0.25, 0.25}, 0);
  frame.place = -1;
  return frame;
}

TemporalFilter filterOf(const TemporalFilterOptions& options = {},
                        const Adjacency& adjacency = Adjacency(4)) {
  return TemporalFilter(modelOf({50, 50, 50, 50}), adjacency, options);
}

/// Shows `frame` at `rate` Hz from stamp `start` to `end`. Returns the last answer.
FilteredAnswer show(TemporalFilter& filter, const Recognition& frame, double start, double end,
                    double rate = 5, const std::optional<Motion>& motion = std::nullopt) {
  FilteredAnswer last;
  for (int i = 0; start + i / rate < end; ++i) {
    last = filter.update(start + i / rate, frame, motion);
  }
  return last;
}

TEST(TemporalFilter, IsTheForwardAlgorithm) {
  // The probabilities of the last state, by summing over all sequences of states.
  TemporalFilterOptions options;
  options.outlier_share = 0.2;
  options.decorrelation_time = 1;
  Adjacency adjacency(3);
  adjacency.join(0, 1);
  adjacency.join(1, 2);
  const std::vector<Recognition> frames{seen({0.7, 0.2, 0.1}), seen({0.3, 0.6, 0.1}, 0.4),
                                        seen({0.1, 0.1, 0.8}), seen({0.2, 0.2, 0.6}, 0.1)};
  constexpr double kStep = 0.4;
  const double fractions[] = {0.5, 0.25, 0.25};
  const auto likelihood = [&](std::size_t frame, int state) {
    const Recognition& f = frames[frame];
    const auto tempered = [](double ratio) { return 0.8 * ratio + 0.2; };
    double by_room[3];
    for (int k = 0; k < 3; ++k) by_room[k] = tempered(f.probabilities[k] / fractions[k]);
    const double best = std::max({by_room[0], by_room[1], by_room[2]});
    const double whole = state == 3 ? tempered((1 - f.evidence) / (1 - kThreshold))
                                    : tempered(f.evidence / kThreshold) * by_room[state] / best;
    return std::pow(whole, frame == 0 ? 1.0 : kStep / options.decorrelation_time);
  };
  TransitionModel chain(adjacency, options.unknown_share, options.jump_share);
  Eigen::MatrixXd step(4, 4);
  for (int state = 0; state < 4; ++state) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Unit(4, state);
    chain.advance(kStep / options.dwell_time, row);
    step.row(state) = row;
  }
  Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(4);
  for (int path = 0; path < 4 * 4 * 4 * 4; ++path) {
    double probability = 1;
    int before = -1, state = -1;
    for (std::size_t i = 0, digits = path; i < frames.size(); ++i, digits /= 4) {
      before = state;
      state = static_cast<int>(digits % 4);
      probability *= (i == 0 ? chain.prior()[state] : step(before, state)) * likelihood(i, state);
    }
    expected[state] += probability;
  }
  expected /= expected.sum();

  TemporalFilter filter(modelOf({99, 49, 49}), adjacency, options);
  FilteredAnswer last;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    last = filter.update(100 + kStep * static_cast<double>(i), frames[i]);
  }
  EXPECT_TRUE(last.probabilities.isApprox(expected, 1e-9)) << last.probabilities;
}

TEST(TemporalFilter, ConstantFramesConverge) {
  TemporalFilter filter = filterOf();
  EXPECT_TRUE(filter.update(0, seen(2)).changed);
  const FilteredAnswer early = show(filter, seen(2), 0.2, 5);
  EXPECT_FALSE(early.changed);
  EXPECT_EQ(early.place, 2);
  EXPECT_GT(early.confidence, 0.9);
  EXPECT_EQ(early.confidence, early.probabilities[2]);
  const FilteredAnswer late = show(filter, seen(2), 5, 60);
  EXPECT_NEAR(late.confidence, show(filter, seen(2), 60, 61).confidence, 1e-6);
}

TEST(TemporalFilter, FrameRateDoesNotMatter) {
  const auto changeAt = [](double rate) {
    TemporalFilter filter = filterOf();
    show(filter, seen(0), 0, 10, rate);
    for (double stamp = 10;; stamp += 1 / rate) {
      if (filter.update(stamp, seen(1)).changed) return stamp - 10;
    }
  };
  const double slow = changeAt(5), fast = changeAt(30);
  EXPECT_GT(fast, 0.1);
  EXPECT_LT(fast, 2);
  EXPECT_NEAR(slow, fast, 0.21);

  TemporalFilter five = filterOf(), thirty = filterOf();
  const FilteredAnswer slow_answer = show(five, seen(0), 0, 10.01, 5);
  const FilteredAnswer fast_answer = show(thirty, seen(0), 0, 10.01, 30);
  EXPECT_NEAR(slow_answer.confidence, fast_answer.confidence, 0.01);
}

TEST(TemporalFilter, AnswersUnknownWhereEvidenceStaysLow) {
  TemporalFilter filter = filterOf();
  EXPECT_EQ(show(filter, seen(1), 0, 5).place, 1);
  EXPECT_EQ(filter.update(5, seen(1, 0.05)).place, 1) << "one frame is not enough";
  const FilteredAnswer unknown = show(filter, seen(1, 0.05), 5.2, 12);
  EXPECT_EQ(unknown.place, -1);
  EXPECT_GT(unknown.confidence, 0.5);
  EXPECT_EQ(unknown.confidence, unknown.probabilities[4]);
  EXPECT_EQ(show(filter, seen(1), 12, 20).place, 1);
}

TEST(TemporalFilter, TheUnknownThresholdCanChange) {
  TemporalFilter strict = filterOf(), lenient = filterOf();
  strict.setUnknownThreshold(0.95);
  lenient.setUnknownThreshold(0.1);
  EXPECT_EQ(show(strict, seen({0.3, 0.3, 0.2, 0.2}, 0.6), 0, 20).place, -1);
  EXPECT_EQ(show(lenient, seen({0.4, 0.2, 0.2, 0.2}, 0.6), 0, 20).place, 0);
}

TEST(TemporalFilter, FramesWithoutFeaturesSayNothingAndDoubtGrows) {
  TemporalFilter filter = filterOf();
  const double before = show(filter, seen(1), 0, 5).confidence;
  const FilteredAnswer soon = show(filter, nothingSeen(), 5, 7);
  EXPECT_EQ(soon.place, 1);
  EXPECT_LT(soon.confidence, before);
  EXPECT_EQ(show(filter, nothingSeen(), 7, 200).place, -1);
}

TEST(TemporalFilter, StandingAddsNothing) {
  TemporalFilter filter = filterOf();
  const Motion still;
  const Eigen::RowVectorXd once = filter.update(0, seen(3), still).probabilities;
  const FilteredAnswer later = show(filter, seen(0), 0.2, 60, 5, still);
  EXPECT_TRUE(later.probabilities.isApprox(once, 1e-12));
  EXPECT_EQ(later.place, 3);
}

TEST(TemporalFilter, TurningIsSeeingMoreOfTheSameRoom) {
  // Nine radians within one decorrelation time, which would count as one frame without odometry.
  const Motion turning{0, 1};
  TemporalFilter blind = filterOf(), turned = filterOf();
  const double without = show(blind, seen(2), 0, 0.5, 20).confidence;
  const double with = show(turned, seen(2), 0, 0.5, 20, turning).confidence;
  EXPECT_GT(with, without);
  EXPECT_GT(with, 0.999);

  // Turning cannot leave a room either, so certainty does not decay over time.
  const Eigen::RowVectorXd before = turned.update(0.5, seen(2), turning).probabilities;
  const FilteredAnswer after = show(turned, nothingSeen(), 0.6, 60, 5, turning);
  EXPECT_EQ(after.place, 2);
  EXPECT_TRUE(after.probabilities.isApprox(before, 1e-12));
  EXPECT_LT(show(blind, nothingSeen(), 0.6, 60).confidence, 0.5);
}

TEST(TemporalFilter, TheMapKeepsOutRoomsThatDoNotAdjoin) {
  Adjacency row(4);
  for (int room = 0; room < 3; ++room) row.join(room, room + 1);
  TemporalFilter with_map = filterOf({}, row), without_map = filterOf();
  const auto flicker = [](TemporalFilter& filter) {
    show(filter, seen(0), 0, 20);
    double most = 0;
    for (double stamp = 20; stamp < 20.5; stamp += 0.2) {
      most = std::max(most, filter.update(stamp, seen(3)).probabilities[3]);
    }
    return most;
  };
  const double forbidden = flicker(with_map), allowed = flicker(without_map);
  EXPECT_LT(forbidden, allowed / 5);
  EXPECT_EQ(show(with_map, seen(3), 20.6, 30).place, 3) << "a robot that was carried there";
}

TEST(TemporalFilter, AnAnswerStaysForItsMinimumDwell) {
  TemporalFilterOptions options;
  options.minimum_dwell = 4;
  options.decorrelation_time = 0.2;
  TemporalFilter filter = filterOf(options);
  filter.update(0, seen(0));
  double last_change = 0;
  for (int i = 1; i < 500; ++i) {
    const double stamp = i / 5.0;
    if (!filter.update(stamp, seen(i / 10 % 2)).changed) continue;
    EXPECT_GE(stamp - last_change, 4 - 1e-9);
    last_change = stamp;
  }
  EXPECT_GT(last_change, 50);
}

TEST(TemporalFilter, BackwardTimeALongGapAndResetForget) {
  const TemporalFilterOptions options;
  const FilteredAnswer fresh = filterOf().update(0, seen(1));
  const auto afterwards = [&](double stamp, bool reset) {
    TemporalFilter filter = filterOf();
    show(filter, seen(0), 100, 110);
    if (reset) filter.reset();
    return filter.update(stamp, seen(1));
  };
  for (const FilteredAnswer& answer :
       {afterwards(109.7, false), afterwards(0, false),
        afterwards(110 + options.maximum_gap, false), afterwards(110, true)}) {
    EXPECT_EQ(answer.probabilities, fresh.probabilities);
    EXPECT_EQ(answer.place, 1);
    EXPECT_TRUE(answer.changed);
  }
  EXPECT_EQ(afterwards(110 + options.maximum_gap / 2, false).probabilities.sum() > 0, true);
  EXPECT_EQ(afterwards(110, false).place, 0);
}

TEST(TemporalFilter, TheSameStampTwiceAddsNothing) {
  TemporalFilter filter = filterOf();
  const Eigen::RowVectorXd once = filter.update(7, seen(1)).probabilities;
  EXPECT_TRUE(filter.update(7, seen(2)).probabilities.isApprox(once, 1e-15));
}

TEST(TemporalFilter, StaysFiniteForCertainFrames) {
  TemporalFilter filter = filterOf();
  filter.setUnknownThreshold(0);
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> probabilities(4, 0);
    probabilities[i / 100 % 4] = 1;
    const FilteredAnswer answer =
        filter.update(i * 0.2, seen(probabilities, i % 7 < 3 ? 0.0 : 1.0));
    ASSERT_TRUE(answer.probabilities.allFinite());
    ASSERT_NEAR(answer.probabilities.sum(), 1, 1e-12);
    ASSERT_GE(answer.probabilities.minCoeff(), 0);
  }
}

TEST(TemporalFilter, RefusesOptionsOutOfRange) {
  const auto refuses = [](const std::string& key, double value) {
    TemporalFilterOptions options;
    TemporalFilterOptions::visit(options, [&](const char* name, double& field, const char*) {
      if (name == key) field = value;
    });
    const std::string error = errorOf([&] { options.check(); });
    return error.find("'" + key + "'") != std::string::npos;
  };
  const TemporalFilterOptions defaults;
  EXPECT_NO_THROW(defaults.check());
  TemporalFilterOptions::visit(defaults, [&](const char* key, double, const char*) {
    EXPECT_TRUE(refuses(key, -1)) << key;
    EXPECT_TRUE(refuses(key, std::numeric_limits<double>::quiet_NaN())) << key;
  });
}

}  // namespace
}  // namespace place_recognition
