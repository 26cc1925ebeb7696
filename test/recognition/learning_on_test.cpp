#include "recognition/training/learning_on.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <random>

namespace place_recognition {
namespace {

constexpr int kOld = 12;
constexpr int kAdded = 5;
constexpr int kPlaces = 3;
constexpr double kTiny = 1e-9;  // ridge

/// A Gaussian kernel of random points in the plane.
Eigen::MatrixXd kernelOfPoints() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  Eigen::MatrixXd points(kOld + kAdded, 2);
  for (Eigen::Index i = 0; i < points.size(); ++i) points(i) = coordinate(random);
  Eigen::MatrixXd kernel(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < kernel.rows(); ++i) {
    for (Eigen::Index j = 0; j < kernel.cols(); ++j) {
      kernel(i, j) = std::exp(-3 * (points.row(i) - points.row(j)).squaredNorm());
    }
  }
  return kernel;
}

/// Machines over the old points that answer -0.8 to 0.2 at random there.
BinarySvms machinesOver(const Eigen::MatrixXd& kernel) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> value(-0.8, 0.2);
  Eigen::MatrixXd values(kOld, kPlaces);
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = value(random);
  const Eigen::RowVectorXd biases = Eigen::RowVectorXd::Constant(kPlaces, -0.5);
  const Eigen::MatrixXd weights =
      kernel.topLeftCorner(kOld, kOld).fullPivLu().solve(values.rowwise() - biases);
  return {kPlaces, false, weights, biases};
}

std::vector<int> all() {
  std::vector<int> rows(kOld + kAdded);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

TEST(LearningOn, LeavesTheVectorsAsTheyAreAndLetsAddedSamplesLead) {
  const Eigen::MatrixXd kernel = kernelOfPoints();
  const BinarySvms before = machinesOver(kernel);
  const std::vector<int> labels(kOld + kAdded, 1);
  const BinarySvms after = learnOn(before, PackedGram(kernel), all(), labels, kTiny);
  const Eigen::MatrixXd values_before = before.decisionValues(kernel.leftCols(kOld));
  const Eigen::MatrixXd values = after.decisionValues(kernel);
  EXPECT_NEAR((values - values_before).topRows(kOld).cwiseAbs().maxCoeff(), 0, 1e-5);
  for (Eigen::Index i = kOld; i < kOld + kAdded; ++i) {
    const double others = std::max(values(i, 0), values(i, 2));
    EXPECT_NEAR(values(i, 1), std::max(values_before(i, 1), std::min(1.0, others + 1)), 1e-5);
    EXPECT_GE(values(i, 1) - others, 1 - 1e-5);
    EXPECT_LE(others, std::max(values_before(i, 0), values_before(i, 2)) + 1e-5);
  }
}

TEST(LearningOn, WhatLeadsAlreadyChangesNothing) {
  const Eigen::MatrixXd kernel = kernelOfPoints();
  BinarySvms before = machinesOver(kernel);
  before.biases[2] = 5;
  const std::vector<int> labels(kOld + kAdded, 2);
  const BinarySvms after = learnOn(before, PackedGram(kernel), all(), labels, kTiny);
  EXPECT_EQ(after.weights.topRows(kOld), before.weights);
  EXPECT_TRUE(after.weights.bottomRows(kAdded).isZero(0));
  EXPECT_EQ(after.biases, before.biases);
}

}  // namespace
}  // namespace place_recognition
