#include "tuning/score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "place_recognition/calibration.h"

namespace place_recognition {
namespace {

/// Three recorded images of two rooms, and a changed copy of the first.
TuningSamples fourSamples() {
  TuningSamples samples;
  samples.places = {"a", "b"};
  samples.origins = {{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {0, 0, 0}};
  samples.recorded = 3;
  samples.source = {0, 1, 2, 0};
  samples.folds = {{{}, {0, 1, 2, 3}}};
  return samples;
}

HeldOutValues decision_values(const std::vector<std::array<double, 2>>& rows) {
  HeldOutValues held_out;
  held_out.decision_values.resize(static_cast<Eigen::Index>(rows.size()), 2);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    held_out.decision_values.row(static_cast<Eigen::Index>(i)) << rows[i][0], rows[i][1];
  }
  held_out.valid.assign(rows.size(), true);
  return held_out;
}

TEST(Score, LogLossIsTheMeanOfTheRoomsMeansOverLights) {
  const TuningSamples samples = fourSamples();
  const HeldOutValues held_out = decision_values({{1, 0}, {0.2, 0}, {0.3, 0.5}, {-0.1, 0}});
  const Calibration calibration =
      fitCalibration(held_out.decision_values, std::vector<int>{0, 0, 1, 0});
  const auto loss = [&](int i, int place) {
    return -std::log(calibration.probabilities(held_out.decision_values.row(i))[place]);
  };
  const Score result = score(held_out, samples);
  const double first = (loss(0, 0) + loss(3, 0)) / 2;
  EXPECT_NEAR(result.losses[0], first, 1e-12);
  EXPECT_NEAR(result.log_loss, ((first + loss(1, 0)) / 2 + loss(2, 1)) / 2, 1e-12);
  EXPECT_DOUBLE_EQ(result.rate, 1);
  EXPECT_DOUBLE_EQ(result.changed_rate, 0);
}

TEST(Score, MissingDecisionValuesKnowNothing) {
  const TuningSamples samples = fourSamples();
  HeldOutValues held_out = decision_values({{1, 0}, {0, 0}, {0, 1}, {1, 0}});
  held_out.valid[1] = false;
  const Score result = score(held_out, samples);
  EXPECT_NEAR(result.losses[1], std::log(2), 1e-12);
  EXPECT_DOUBLE_EQ(result.rate, 0.75) << "room a: one of two";
}

TEST(Score, ErrorOfADifferenceIsThatOfPairedMeans) {
  const TuningSamples samples = fourSamples();
  Score a, b;
  a.losses = {0.5, 0.1, 0.7};
  b.losses = {0.2, 0.2, 0.3};
  // Differences of room a: 0.3 and -0.1, variance 0.04 of two; of room b: one value, variance 0.
  EXPECT_NEAR(differenceError(a, b, samples), std::sqrt(0.04 / 2) / 2, 1e-12);
  EXPECT_DOUBLE_EQ(differenceError(a, a, samples), 0);
}

}  // namespace
}  // namespace place_recognition
