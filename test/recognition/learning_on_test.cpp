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

/// Random changes of the added points; none for one of them.
Eigen::MatrixXd drawnChanges() {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> change(-1, 1);
  Eigen::MatrixXd changes(kAdded, kPlaces);
  for (Eigen::Index i = 0; i < changes.size(); ++i) changes(i) = change(random);
  changes.row(2).setZero();
  return changes;
}

TEST(LearningOn, LeavesTheVectorsAsTheyAreAndChangesAddedSamplesAsAsked) {
  const Eigen::MatrixXd kernel = kernelOfPoints();
  const BinarySvms before = machinesOver(kernel);
  const Eigen::MatrixXd changes = drawnChanges();
  const BinarySvms after = learnOn(before, PackedGram(kernel), all(), changes, kTiny);
  const Eigen::MatrixXd changed =
      after.decisionValues(kernel) - before.decisionValues(kernel.leftCols(kOld));
  EXPECT_NEAR(changed.topRows(kOld).cwiseAbs().maxCoeff(), 0, 1e-5);
  for (const Eigen::Index i : {0, 1, 3, 4}) {
    EXPECT_NEAR((changed.row(kOld + i) - changes.row(i)).cwiseAbs().maxCoeff(), 0, 1e-5) << i;
  }
  EXPECT_TRUE(after.weights.row(kOld + 2).isZero(0)) << "asks for no change and is not needed";
}

TEST(LearningOn, NoChangeChangesNothing) {
  const Eigen::MatrixXd kernel = kernelOfPoints();
  const BinarySvms before = machinesOver(kernel);
  const BinarySvms after =
      learnOn(before, PackedGram(kernel), all(), Eigen::MatrixXd::Zero(kAdded, kPlaces), kTiny);
  EXPECT_EQ(after.weights.topRows(kOld), before.weights);
  EXPECT_TRUE(after.weights.bottomRows(kAdded).isZero(0));
  EXPECT_EQ(after.biases, before.biases);
}

TEST(ChangesToLead, AreTheSmallestOnes) {
  // The true place falls 1 short of the required lead of 0.4 over the second place, and 0.2 short
  // of that over the third.
  const Eigen::RowVector4d values(-0.2, 0.4, -0.4, -0.9);
  const Eigen::MatrixXd changes = changesToLead(values, {0}, {0.4});
  EXPECT_LT((changes - Eigen::RowVector4d(0.5, -0.5, 0, 0)).norm(), 1e-12);
}

// Of all changes x with x_own - x_k >= needed_k, the smallest is a sum of the constraints' normals
// with non-negative weights, which are zero unless the constraint holds with equality.
TEST(ChangesToLead, ObeyTheConditionsOfKarushKuhnAndTucker) {
  constexpr double kLead = 0.5;
  std::mt19937 random(10);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::MatrixXd values(200, 6);
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = value(random);
  std::vector<int> labels;
  for (int i = 0; i < 200; ++i) labels.push_back(i % 6);
  const Eigen::MatrixXd changes =
      changesToLead(values, labels, std::vector<double>(labels.size(), kLead));
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const int own = labels[static_cast<std::size_t>(i)];
    const Eigen::RowVectorXd after = values.row(i) + changes.row(i);
    EXPECT_NEAR(changes.row(i).sum(), 0, 1e-12);
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      if (k == own) continue;
      const double lead = after[own] - after[k];
      EXPECT_GE(lead, kLead - 1e-12);
      EXPECT_LE(changes(i, k), 0);
      if (changes(i, k) < 0) {
        EXPECT_NEAR(lead, kLead, 1e-12);
      }
    }
  }
}

TEST(ChangesToLead, AreZeroForWhatLeadsAlready) {
  const Eigen::RowVector3d values(0.2, 0.9, 0.4);
  EXPECT_TRUE(changesToLead(values, {1}, {0.5}).isZero(0));
  EXPECT_FALSE(changesToLead(values, {1}, {0.51}).isZero(0));
}

}  // namespace
}  // namespace place_recognition
