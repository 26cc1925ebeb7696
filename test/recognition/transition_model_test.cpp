#include "recognition/over_time/transition_model.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

/// Rooms 0 - 1 - 2 in a row.
Adjacency row() {
  Adjacency adjacency(3);
  adjacency.join(0, 1);
  adjacency.join(1, 2);
  return adjacency;
}

Eigen::RowVectorXd certain(int state, int states) {
  return Eigen::RowVectorXd::Unit(states, state);
}

TEST(TransitionModel, FollowsItsDifferentialEquation) {
  // db/dt = b (J - I), with J written out for unknown share 0.2 (so that a quarter of the changes
  // lead to 'unknown') and jump share 0.1, by the midpoint rule in small steps.
  Eigen::Matrix4d jump;
  jump << 0, 0.95 * 0.75, 0.05 * 0.75, 0.25,  //
      0.5 * 0.75, 0, 0.5 * 0.75, 0.25,        //
      0.05 * 0.75, 0.95 * 0.75, 0, 0.25,      //
      1.0 / 3, 1.0 / 3, 1.0 / 3, 0;
  const Eigen::Matrix4d rate = jump - Eigen::Matrix4d::Identity();
  TransitionModel chain(row(), 0.2, 0.1);
  for (int state = 0; state < 4; ++state) {
    Eigen::RowVector4d expected = certain(state, 4);
    constexpr int kSteps = 10000;
    const double step = 0.7 / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      expected += step * (expected + step / 2 * expected * rate) * rate;
    }
    Eigen::RowVectorXd belief = certain(state, 4);
    chain.advance(0.7, belief);
    EXPECT_TRUE(belief.isApprox(expected, 1e-7)) << belief << " instead of " << expected;
  }
}

TEST(TransitionModel, ManyStepsAreOne) {
  TransitionModel chain(row(), 0.1, 0.01);
  Eigen::RowVectorXd one = certain(0, 4), many = one;
  chain.advance(3, one);
  for (int i = 0; i < 300; ++i) chain.advance(0.01, many);
  EXPECT_TRUE(one.isApprox(many, 1e-12));
  Eigen::RowVectorXd same = one;
  chain.advance(0, same);
  EXPECT_TRUE(same.isApprox(one, 1e-15));
}

TEST(TransitionModel, GoesBackByTheTransposeOfTheWayForward) {
  TransitionModel chain(row(), 0.2, 0.1);
  Eigen::Matrix4d forward;
  for (int state = 0; state < 4; ++state) {
    Eigen::RowVectorXd belief = certain(state, 4);
    chain.advance(0.7, belief);
    forward.row(state) = belief;
  }
  const Eigen::Vector4d later(0.1, 0.6, 0.05, 0.9);
  Eigen::RowVectorXd likelihood = later.transpose();
  chain.goBack(0.7, likelihood);
  const Eigen::RowVectorXd expected = (forward * later).transpose();
  EXPECT_TRUE(likelihood.isApprox(expected / expected.sum(), 1e-12));
}

TEST(TransitionModel, EndsAtTheShareOfUnknown) {
  TransitionModel chain(row(), 0.1, 0.01);
  for (const double changes : {50.0, 1e9}) {
    Eigen::RowVectorXd belief = certain(2, 4);
    chain.advance(changes, belief);
    EXPECT_NEAR(belief.sum(), 1, 1e-12);
    EXPECT_NEAR(belief[3], 0.1, 1e-9);
  }
  EXPECT_NEAR(chain.prior()[3], 0.1, 1e-15);
  EXPECT_NEAR(chain.prior().sum(), 1, 1e-15);
}

TEST(TransitionModel, WithoutAShareNothingBecomesUnknownAndASingleRoomStays) {
  TransitionModel chain(Adjacency(1), 0, 0);
  Eigen::RowVectorXd belief = certain(0, 2);
  chain.advance(5, belief);
  EXPECT_NEAR(belief[0], 1, 1e-12);
  EXPECT_EQ(belief[1], 0);
}

}  // namespace
}  // namespace place_recognition
