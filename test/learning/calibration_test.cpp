#include "place_recognition/calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace place_recognition {
namespace {

TEST(Calibration, RecoversTheSlopeThatMadeTheData) {
  std::mt19937 generator(9);
  const auto uniform = [&] { return generator() / 4294967296.0; };
  const Calibration truth{2.5};
  Eigen::MatrixXd decision_values(20000, 3);
  std::vector<int> labels;
  for (Eigen::Index i = 0; i < decision_values.rows(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) decision_values(i, k) = 4 * uniform() - 2;
    const Eigen::RowVectorXd p = truth.probabilities(decision_values.row(i));
    const double draw = uniform();
    labels.push_back(draw < p[0] ? 0 : draw < p[0] + p[1] ? 1 : 2);
  }
  EXPECT_NEAR(fitCalibration(decision_values, labels).slope, 2.5, 0.1);
  // The unit of the decision values does not change the evidence.
  EXPECT_NEAR(fitCalibration(1000 * decision_values, labels).slope, 0.0025, 0.0001);
}

TEST(Calibration, IsTheSlopeOfGreatestLikelihood) {
  // Two places: p_0 = 1 / (1 + exp(-slope d)), d the difference of decision values. Three right
  // frames with d = 1, one wrong, and one without information: the target probability of right
  // is 3.5 / 5.
  Eigen::MatrixXd decision_values(4, 2);
  decision_values << 0.5, -0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0.5;
  EXPECT_NEAR(fitCalibration(decision_values, {0, 0, 1, 0}).slope, std::log(7.0 / 3), 1e-9);
}

TEST(Calibration, FollowsTheFormulas) {
  const Calibration calibration{0.5};
  const Eigen::RowVector3d decision_values(1, -2, 0.25);
  const Eigen::RowVector3d powers(std::exp(0.5), std::exp(-1.0), std::exp(0.125));
  EXPECT_TRUE(calibration.probabilities(decision_values).isApprox(powers / powers.sum(), 1e-14));
  EXPECT_NEAR(calibration.evidence(decision_values), powers.sum() / (1 + powers.sum()), 1e-14);
  EXPECT_NEAR(calibration.logOdds(decision_values), std::log(powers.sum()), 1e-14);
}

void expectProbabilities(const Calibration& calibration,
                         const Eigen::RowVectorXd& decision_values) {
  const Eigen::RowVectorXd p = calibration.probabilities(decision_values);
  EXPECT_TRUE(p.allFinite()) << p;
  EXPECT_GE(p.minCoeff(), 0);
  EXPECT_NEAR(p.sum(), 1, 1e-12);
  Eigen::Index most_probable = 0;
  Eigen::Index largest = 0;
  p.maxCoeff(&most_probable);
  decision_values.maxCoeff(&largest);
  EXPECT_EQ(most_probable, largest) << decision_values;
  EXPECT_GE(calibration.evidence(decision_values), 0);
  EXPECT_LE(calibration.evidence(decision_values), 1);
}

TEST(Calibration, IsFiniteForExtremeDecisionValues) {
  for (const double slope : {1e-6, 1.0, 1e3}) {
    for (const double a : {-1.7e308, -1e6, 0.0, 1e6, 1.7e308}) {
      for (const double b : {-1.7e308, -1e6, 0.0, 1e6, 1.7e308}) {
        expectProbabilities({slope}, Eigen::RowVector3d(a, b, -1e6));
      }
    }
  }
}

void expectUsable(const Eigen::MatrixXd& decision_values, const std::vector<int>& labels) {
  const Calibration calibration = fitCalibration(decision_values, labels);
  EXPECT_TRUE(std::isfinite(calibration.slope));
  EXPECT_GT(calibration.slope, 0);
  for (Eigen::Index i = 0; i < decision_values.rows(); ++i) {
    expectProbabilities(calibration, decision_values.row(i));
  }
}

TEST(Calibration, SurvivesDegenerateInput) {
  const Eigen::MatrixXd separated =
      (Eigen::MatrixXd(4, 2) << 1, -1, 2, -2, -1, 1, -2, 2).finished();
  expectUsable(separated, {0, 0, 1, 1});
  expectUsable(separated, {0, 0, 0, 0});  // one place only
  expectUsable(separated, {1, 1, 0, 0});  // decision values that favour the wrong place
  expectUsable(Eigen::MatrixXd::Constant(4, 2, 0.5), {0, 1, 0, 1});
  expectUsable(Eigen::MatrixXd::Zero(4, 2), {0, 1, 0, 1});
  expectUsable(1e6 * separated, {0, 0, 1, 1});
  expectUsable(8e307 * separated, {0, 0, 1, 1});
  expectUsable(1e-300 * separated, {0, 0, 1, 1});
  EXPECT_EQ(fitCalibration(Eigen::MatrixXd(0, 2), {}).slope, 1);
}

TEST(Calibration, MoreFramesAreMoreCertain) {
  const Eigen::MatrixXd few = (Eigen::MatrixXd(2, 2) << 1, -1, -1, 1).finished();
  const Eigen::MatrixXd many = few.replicate(10, 1);
  std::vector<int> labels;
  for (int i = 0; i < 20; ++i) labels.push_back(i % 2);
  EXPECT_GT(fitCalibration(many, labels).slope, fitCalibration(few, {0, 1}).slope);
}

TEST(Evidence, IsOneHalfWhereTheWantedShareLiesBelowAndNearlyOneAtTheMedian) {
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  Eigen::VectorXd log_sums(2000);
  Eigen::VectorXd familiarity(2000);
  for (Eigen::Index i = 0; i < log_sums.size(); ++i) {
    log_sums[i] = 1 + 3 * normal(generator);
    familiarity[i] = 0.6 + 0.01 * normal(generator);
  }
  Calibration calibration;
  calibration.weights = fitEvidence(log_sums, familiarity, 0.1);
  int below_half = 0;
  int below_median = 0;
  for (Eigen::Index i = 0; i < log_sums.size(); ++i) {
    const Eigen::RowVectorXd decision_value = Eigen::RowVectorXd::Constant(1, log_sums[i]);
    const double evidence = calibration.evidence(decision_value, familiarity[i]);
    below_half += evidence < 0.5 ? 1 : 0;
    below_median += evidence < 1 / (1 + std::exp(-3.0)) ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 200, 1);
  EXPECT_NEAR(below_median, 1000, 1);
  // Each is measured in units of its own spread.
  EXPECT_NEAR(calibration.weights.decision_values * 3, calibration.weights.familiarity * 0.01, 0.2);
}

TEST(Evidence, WhatIsAlwaysEqualDoesNotCount) {
  const Eigen::VectorXd log_sums = Eigen::VectorXd::LinSpaced(9, -1, 1);
  const Eigen::VectorXd familiarity = Eigen::VectorXd::Constant(9, 0.5);
  const EvidenceWeights weights = fitEvidence(log_sums, familiarity, 0.05);
  EXPECT_GT(weights.decision_values, 0);
  EXPECT_EQ(weights.familiarity, 0);
  const EvidenceWeights blank = fitEvidence(familiarity, familiarity, 0.05);
  EXPECT_EQ(blank.decision_values, 0);
  EXPECT_TRUE(std::isfinite(blank.offset));
}

}  // namespace
}  // namespace place_recognition
