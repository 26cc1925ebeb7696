#include "place_recognition/calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace place_recognition {
namespace {

TEST(Calibration, RecoversTheSlopeThatMadeTheData) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(0, 1);
  const int frames = 20000;
  Eigen::MatrixXd margins(frames, 3);
  std::vector<int> labels;
  for (int i = 0; i < frames; ++i) {
    for (int k = 0; k < 3; ++k) margins(i, k) = 2 * uniform(generator) - 1;
    const Eigen::RowVectorXd p = Calibration{2.5}.probabilities(margins.row(i));
    const double draw = uniform(generator);
    labels.push_back(draw < p[0] ? 0 : draw < p[0] + p[1] ? 1 : 2);
  }
  EXPECT_NEAR(fitCalibration(margins, labels).slope, 2.5, 0.1);
  EXPECT_NEAR(fitCalibration(10 * margins, labels).slope, 0.25, 0.01);
}

TEST(Calibration, ProbabilitiesAreTheFormula) {
  const Calibration calibration{2};
  const Eigen::RowVector3d margins(0.5, -1, 2);
  const double sum = std::exp(1) + std::exp(-2) + std::exp(4);
  EXPECT_TRUE(calibration.probabilities(margins).isApprox(
      Eigen::RowVector3d(std::exp(1), std::exp(-2), std::exp(4)) / sum, 1e-14));
  EXPECT_NEAR(calibration.evidence(margins), sum / (sum + 1), 1e-14);
}

TEST(Calibration, EvidenceFallsWhereEveryMachineSaysNo) {
  const Calibration calibration{3};
  const Eigen::RowVector3d margins(0.5, -1, -0.2);
  const Eigen::RowVector3d lower = margins.array() - 1;
  EXPECT_TRUE(calibration.probabilities(lower).isApprox(calibration.probabilities(margins), 1e-12));
  EXPECT_LT(calibration.evidence(lower), calibration.evidence(margins));
}

void expectProbabilities(const Eigen::RowVectorXd& p) {
  EXPECT_TRUE(p.allFinite()) << p;
  EXPECT_GE(p.minCoeff(), 0);
  EXPECT_NEAR(p.sum(), 1, 1e-12);
}

TEST(Calibration, IsFiniteForExtremeMargins) {
  const Calibration calibration{3};
  for (const double a : {-1.7e308, -1e6, 0.0, 1e6, 1.7e308}) {
    for (const double b : {-1.7e308, -1e6, 0.0, 1e6, 1.7e308}) {
      const Eigen::RowVector3d margins(a, b, -1e6);
      expectProbabilities(calibration.probabilities(margins));
      EXPECT_GE(calibration.evidence(margins), 0);
      EXPECT_LE(calibration.evidence(margins), 1);
    }
  }
}

void expectUsable(const Eigen::MatrixXd& margins, const std::vector<int>& labels) {
  const Calibration calibration = fitCalibration(margins, labels);
  EXPECT_TRUE(std::isfinite(calibration.slope));
  EXPECT_GT(calibration.slope, 0);
  for (Eigen::Index i = 0; i < margins.rows(); ++i) {
    expectProbabilities(calibration.probabilities(margins.row(i)));
  }
}

TEST(Calibration, SurvivesDegenerateInput) {
  const Eigen::MatrixXd separated =
      (Eigen::MatrixXd(4, 2) << 1, -1, 2, -2, -1, 1, -2, 2).finished();
  expectUsable(separated, {0, 0, 1, 1});
  expectUsable(separated, {0, 0, 0, 0});  // one place only
  expectUsable(separated, {1, 1, 0, 0});  // margins tell the opposite
  expectUsable(Eigen::MatrixXd::Constant(4, 2, 0.5), {0, 1, 0, 1});
  expectUsable(Eigen::MatrixXd::Zero(4, 2), {0, 1, 0, 1});
  expectUsable(1e6 * separated, {0, 0, 1, 1});
  expectUsable(8e307 * separated, {0, 0, 1, 1});
  expectUsable(1e-300 * separated, {0, 0, 1, 1});
  expectUsable(Eigen::MatrixXd(0, 2), {});
}

}  // namespace
}  // namespace place_recognition
