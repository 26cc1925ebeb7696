#include "learning/column_steps.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace place_recognition {
namespace {

constexpr Eigen::Index kRows = 48;

Eigen::MatrixXd randomMatrix(Eigen::Index columns) {
  static std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(kRows, columns, [&] { return uniform(generator); });
}

class ColumnStepsOf : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  ColumnStepsOf() {
    for (Eigen::Index s = 0; s < q_.cols(); ++s) q_.col(s).normalize();  // not at right angles
    steps_.count = std::get<0>(GetParam());
    for (int s = 0; s < steps_.count; ++s) {
      steps_.q[s] = q_.col(s).data();
      for (int t = 0; t < s; ++t) steps_.overlaps[s][t] = q_.col(s).dot(q_.col(t));
    }
  }

  /// Takes the steps out of `columns` from `first` on; returns the products.
  Eigen::MatrixXd takeOutOf(Eigen::MatrixXd& columns, Eigen::Index first, int count) {
    Eigen::MatrixXd products(steps_.count, count);
    ColumnTeam team;
    for (; team.count < count; ++team.count) {
      team.values[team.count] = columns.col(first + team.count).data();
      team.products[team.count] = products.col(team.count).data();
    }
    takeOut(steps_, team, kRows);
    return products;
  }

  const int columns_ = std::get<1>(GetParam());
  Eigen::MatrixXd q_ = randomMatrix(ColumnSteps::kMost);
  ColumnSteps steps_;
};

TEST_P(ColumnStepsOf, EqualOneStepAfterTheOther) {
  Eigen::MatrixXd expected = randomMatrix(columns_);
  Eigen::MatrixXd taken = expected;
  const Eigen::MatrixXd products = takeOutOf(taken, 0, columns_);
  for (int s = 0; s < steps_.count; ++s) {
    const Eigen::RowVectorXd product = q_.col(s).transpose() * expected;
    EXPECT_LT((products.row(s) - product).cwiseAbs().maxCoeff(), 1e-13);
    expected -= q_.col(s) * product;
  }
  EXPECT_LT((taken - expected).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_P(ColumnStepsOf, GiveTheSameBitsToEachColumnAlone) {
  Eigen::MatrixXd together = randomMatrix(columns_);
  Eigen::MatrixXd alone = together;
  const Eigen::MatrixXd products = takeOutOf(together, 0, columns_);
  for (int c = 0; c < columns_; ++c) {
    EXPECT_EQ(takeOutOf(alone, c, 1), products.col(c));
  }
  EXPECT_EQ(alone, together);
}

INSTANTIATE_TEST_SUITE_P(EveryCount, ColumnStepsOf,
                         testing::Combine(testing::Range(1, ColumnSteps::kMost + 1),
                                          testing::Range(1, ColumnTeam::kMost + 1)));

}  // namespace
}  // namespace place_recognition
