#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "base/place_name.h"
#include "recognition/model/scores.h"
#include "recognition/training/combination.h"
#include "recognition/training/gamma_choice.h"
#include "recognition/training/model_calibration.h"

namespace place_recognition {
namespace {

TEST(Scores, AverageRateWeighsRoomsEqually) {
  // Room 0: 3 of 4 right; room 1: 0 of 1; room 2 does not occur.
  const std::vector<int> truth{0, 0, 0, 0, 1}, answers{0, 0, 0, 1, -1};
  EXPECT_DOUBLE_EQ(averageRate(truth, answers, 3), (0.75 + 0) / 2);
  EXPECT_DOUBLE_EQ(roomRates(truth, answers, 3).standard_error, std::sqrt(0.75 * 0.25 / 4) / 2);
  EXPECT_EQ(averageRate(std::vector<int>(), std::vector<int>(), 3), 0);
}

TEST(Scores, ConfusedPairsCountBothDirections) {
  // Rooms 0 and 2: 2 of 4 + 1; 0 and 1: 1 of 4 + 2; none is no confusion.
  const std::vector<int> truth{0, 0, 0, 0, 1, 1, 2}, answers{0, 2, 2, 1, 1, -1, 2};
  const std::vector<ConfusedPair> pairs = confusedPairs(truth, answers, 4);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].a, 0);
  EXPECT_EQ(pairs[0].b, 2);
  EXPECT_DOUBLE_EQ(pairs[0].rate, 2.0 / 5);
  EXPECT_DOUBLE_EQ(pairs[0].standard_error, std::sqrt(0.4 * 0.6 / 5));
  EXPECT_EQ(pairs[1].b, 1);
  EXPECT_DOUBLE_EQ(pairs[1].rate, 1.0 / 6);
}

TEST(Scores, CalibrationErrorIsTheWeightedGapOfTheBins) {
  // Bin 0.9..1: mean confidence 0.95, one of two right; bin 0.3..0.4: 0.35, right.
  EXPECT_NEAR(calibrationError({0.94, 0.96, 0.35}, {true, false, true}), (2 * 0.45 + 1 * 0.65) / 3,
              1e-12);
  EXPECT_NEAR(calibrationError({1, 1}, {true, true}), 0, 1e-12);
  EXPECT_EQ(calibrationError({}, {}), 0);
}

TEST(GammaChoice, StaysNearTheNeutralOneAmongEquals) {
  const std::vector<GammaTrial> trials{
      {0.25, 0.90, 0.02}, {0.5, 0.89, 0.02}, {1, 0.87, 0.02}, {2, 0.885, 0.02}, {4, 0.5, 0.05}};
  EXPECT_EQ(chooseGamma(trials, 1), 0.5);  // 1 is too poor; 0.5 comes before 2
  EXPECT_EQ(chooseGamma(trials, 8), 2);    // 4 is too poor
  EXPECT_EQ(chooseGamma({{3, 0, 0}}, 1), 3);
}

TEST(GammaChoice, GridFollowsTheFeatures) {
  KernelOptions options;
  options.gamma = 1;
  Eigen::MatrixXd measures(2, 2);
  measures << 0, 0.5, 0.5, 0;
  const GammaGrid grid = gammaGrid(Kernel(options), measures);
  EXPECT_DOUBLE_EQ(grid.neutral, 1);  // one over twice the mean off the diagonal
  EXPECT_DOUBLE_EQ(grid.gammas.front(), 1.0 / 16);
  EXPECT_DOUBLE_EQ(grid.gammas.back(), 16);
  EXPECT_EQ(gammaGrid(Kernel(options), Eigen::MatrixXd::Zero(3, 3)).neutral, 0.5);
}

CombinedValues heldOut(const Eigen::MatrixXd& decision_values, const std::vector<bool>& valid) {
  return {{decision_values, valid, Eigen::VectorXd::Zero(decision_values.rows())}, decision_values};
}

TEST(Combination, IsTheWeightedMeanOfTheCuesThatAreThere) {
  const Eigen::MatrixXd a = (Eigen::MatrixXd(3, 2) << 1, 2, 3, 4, 0, 0).finished();
  const Eigen::MatrixXd b = (Eigen::MatrixXd(3, 2) << 5, 6, 0, 0, 0, 0).finished();
  const std::vector<HeldOutValues> cues{heldOut(a, {true, true, false}),
                                        heldOut(b, {true, false, false})};
  const CombinedValues combined = combine(cues, {0.25, 0.75}, 0);
  const Eigen::MatrixXd expected =
      (Eigen::MatrixXd(3, 2) << 0.25 * 1 + 0.75 * 5, 0.25 * 2 + 0.75 * 6, 3, 4, 0, 0).finished();
  EXPECT_TRUE(combined.decision_values.isApprox(expected));
  EXPECT_EQ(combined.unlimited, combined.decision_values);
  EXPECT_EQ(combined.valid, (std::vector<bool>{true, true, false}));

  const CombinedValues limited = combine(cues, {0.25, 0.75}, 2);
  EXPECT_NEAR(limited.decision_values(0, 0), 0.5 * std::tanh(0.5) + 1.5 * std::tanh(2.5), 1e-12);
  EXPECT_NEAR(limited.decision_values(1, 1), 2 * std::tanh(2), 1e-12);
  EXPECT_EQ(limited.unlimited, combined.unlimited);
}

TEST(Combination, OneCueCannotOutvoteTheOthersByItsSize) {
  Eigen::MatrixXd loud(1, 2), low(1, 2);
  loud << 9, -9;
  low << -1, 1;
  const std::vector<HeldOutValues> cues{heldOut(loud, {true}), heldOut(low, {true}),
                                        heldOut(low, {true}), heldOut(low, {true})};
  const std::vector<double> equal(4, 0.25);
  EXPECT_GT(combine(cues, equal, 0).decision_values(0), 0);
  EXPECT_LT(combine(cues, equal, 2).decision_values(0), 0);
}

TEST(Combination, LimitsSeveralCuesOfOneAgainstAll) {
  TrainingOptions options;
  options.cues.resize(2);
  EXPECT_EQ(decisionLimit(options), 2);
  options.svm.multiclass = "one-against-one";
  EXPECT_EQ(decisionLimit(options), 0);
  options = TrainingOptions{};
  options.cues.resize(1);
  EXPECT_EQ(decisionLimit(options), 0);
}

TEST(Combination, TriesABoundedNumberOfSharesOfAnyNumberOfCues) {
  const std::map<std::size_t, std::size_t> sizes{{1, 1},     {2, 11},   {3, 66},     {5, 495},
                                                 {11, 1001}, {12, 364}, {17, 969},   {18, 171},
                                                 {44, 990},  {45, 45},  {1500, 1500}};
  for (const auto& [cues, size] : sizes) {
    const std::vector<std::vector<double>> grid = gridOfShares(cues);
    EXPECT_EQ(grid.size(), 1 + size) << cues;
    for (const std::vector<double>& shares : grid) {
      ASSERT_EQ(shares.size(), cues);
      ASSERT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-9) << cues;
    }
  }
}

TEST(Combination, PrefersTheCueThatTellsAndElseThePrior) {
  const std::vector<SampleOrigin> samples{{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {1, 0, 3}};
  const std::vector<bool> all(4, true);
  const Eigen::MatrixXd good = (Eigen::MatrixXd(4, 2) << 1, -1, 1, -1, -1, 1, -1, 1).finished();
  const Eigen::MatrixXd bad = -good;
  const std::vector<double> half{0.5, 0.5};
  const std::vector<double> equal =
      chooseCueWeights({heldOut(good, all), heldOut(good, all)}, half, 0, samples, 2);
  EXPECT_EQ(equal, (std::vector<double>{0.5, 0.5}));
  const std::vector<double> chosen =
      chooseCueWeights({heldOut(bad, all), heldOut(good, all)}, half, 0, samples, 2);
  EXPECT_GT(chosen[1], 0.5);
  EXPECT_EQ(chooseCueWeights({heldOut(good, all)}, {1}, 0, samples, 2), std::vector<double>{1});
  // A prior of five cues that lies between the steps.
  const std::vector<double> prior{0.15, 0.15, 0.15, 0.15, 0.4};
  EXPECT_EQ(
      chooseCueWeights(std::vector<HeldOutValues>(5, heldOut(good, all)), prior, 0, samples, 2),
      prior);
}

TEST(Validation, ThresholdLetsTheWantedShareFall) {
  // Two places, twenty samples each, in four folds; decision values that differ in size.
  std::vector<SampleOrigin> samples;
  Eigen::MatrixXd decision_values(40, 2);
  for (int i = 0; i < 40; ++i) {
    samples.push_back({i % 2, 0, static_cast<double>(i)});
    const double f = 0.1 * (1 + i / 2);
    decision_values.row(i) << (i % 2 == 0 ? f : -f), (i % 2 == 0 ? -f : f);
  }
  const std::vector<Fold> folds = timeBlockFolds(samples, 4, {TimeBlocks{5, 0}});
  const CombinedValues held_out = heldOut(decision_values, std::vector<bool>(40, true));
  const CalibrationSet set{samples, folds, {}, std::vector<bool>(40, true)};
  const Calibrated calibrated = calibrate(held_out, set, 0.25);
  EXPECT_EQ(calibrated.validation.average_rate, 1);
  int below = 0;
  for (int i = 0; i < 40; ++i) {
    below += calibrated.calibration.evidence(decision_values.row(i)) < calibrated.unknown_threshold
                 ? 1
                 : 0;
  }
  EXPECT_NEAR(below, 10, 2);  // each fold was judged with the slope of the others
}

TEST(Validation, SamplesThatDoNotJudgeUnknownOnlyTellHowSureAnAnswerIs) {
  std::vector<SampleOrigin> samples;
  Eigen::MatrixXd decision_values(40, 2);
  std::vector<bool> judges(40, true);
  for (int i = 0; i < 40; ++i) {
    samples.push_back({i % 2, 0, static_cast<double>(i)});
    const double f = (i < 20 ? 0.1 : 0.001) * (1 + i % 20);  // far less for the later samples
    decision_values.row(i) << (i % 2 == 0 ? f : -f), (i % 2 == 0 ? -f : f);
    judges[static_cast<std::size_t>(i)] = i < 20;
  }
  const CombinedValues held_out = heldOut(decision_values, std::vector<bool>(40, true));
  const auto evidenceBelow = [&](const std::vector<bool>& judging) {
    const Calibrated calibrated = calibrate(held_out, {samples, {}, {}, judging}, 0.25);
    int below = 0;
    for (int i = 0; i < 20; ++i) {
      below += calibrated.calibration.evidence(decision_values.row(i)) < 0.5 - 1e-9 ? 1 : 0;
    }
    return below;
  };
  EXPECT_EQ(evidenceBelow(judges), 5) << "a quarter of those that judge";
  EXPECT_EQ(evidenceBelow(std::vector<bool>(40, true)), 0);
  const double all = calibrate(held_out, {samples, {}, {}, judges}, 0.25).calibration.slope;
  EXPECT_EQ(
      calibrate(held_out, {samples, {}, {}, std::vector<bool>(40, true)}, 0.25).calibration.slope,
      all);
}

TEST(Validation, FitsProbabilitiesToLimitedValuesAndEvidenceToUnlimitedOnes) {
  std::vector<SampleOrigin> samples;
  Eigen::MatrixXd decision_values(40, 2);
  for (int i = 0; i < 40; ++i) {
    samples.push_back({i % 2, 0, static_cast<double>(i)});
    const double f = 0.3 * (i % 5 == 0 ? -i : i);
    decision_values.row(i) << (i % 2 == 0 ? f : -f), (i % 2 == 0 ? -f : f);
  }
  const CalibrationSet set{samples, {}, {}, std::vector<bool>(40, true)};
  const std::vector<bool> all(40, true);
  const CombinedValues limited = combine({heldOut(decision_values, all)}, {1}, 2);
  const Calibration calibration = calibrate(limited, set, 0.25).calibration;
  EXPECT_EQ(calibration.slope,
            calibrate(heldOut(limited.decision_values, all), set, 0.25).calibration.slope);
  int below = 0;
  for (int i = 0; i < 40; ++i) {
    below += calibration.evidence(decision_values.row(i)) < 0.5 - 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(below, 10) << "a quarter";
}

TEST(Validation, WorksWithoutAnyHeldOutSample) {
  const CalibrationSet set{{{0, 0, 0}, {1, 0, 1}}, {}, {}, {true, true}};
  const Calibrated calibrated =
      calibrate(heldOut(Eigen::MatrixXd::Zero(2, 2), {false, false}), set, 0.05);
  EXPECT_GT(calibrated.calibration.slope, 0);
  EXPECT_EQ(calibrated.unknown_threshold, 0);
  EXPECT_EQ(calibrated.validation.average_rate, 0);
}

TEST(Names, OfPlacesAreShortPrintableUtf8) {
  for (const char* name :
       {"kitchen", "Elin's office", "K\xc3\xb6k", "\xe5\x8e\xa8\xe6\x88\xbf", "a/b"}) {
    EXPECT_TRUE(isPlaceName(name)) << name;
  }
  for (const std::string& name :
       {std::string(), std::string("a\tb"), std::string("\x7f"), std::string("\xc2\x85"),
        std::string("\xff"), std::string("K\xc3"), std::string("\xe0\x80\x80"),
        std::string(129, 'a'), std::string("a\0b", 3)}) {
    EXPECT_FALSE(isPlaceName(name)) << name;
  }
}

}  // namespace
}  // namespace place_recognition
