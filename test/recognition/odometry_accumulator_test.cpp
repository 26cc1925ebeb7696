// The path between frames, from good and bad odometry poses.

#include "recognition/over_time/odometry_accumulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_recognition {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(OdometryAccumulator, AddsUpDistanceAndTurning) {
  OdometryAccumulator way;
  way.add({0, 0, 0, 0});
  EXPECT_FALSE(way.take(0));  // counting starts here
  way.add({0.1, 0.3, 0.4, 0.2});
  way.add({0.2, 0, 0, -0.1});  // back again, which still adds to the path
  const auto motion = way.take(0.2);
  ASSERT_TRUE(motion);
  EXPECT_DOUBLE_EQ(motion->distance, 1.0);
  EXPECT_DOUBLE_EQ(motion->angle, 0.5);
  const auto none = way.take(0.25);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->distance, 0);
  EXPECT_EQ(none->angle, 0);
}

TEST(OdometryAccumulator, TurnsTheShortWayRound) {
  OdometryAccumulator way;
  way.add({0, 0, 0, 3.1});
  way.take(0);
  way.add({0.1, 0, 0, -3.1});
  const auto motion = way.take(0.1);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->angle, 2 * M_PI - 6.2, 1e-12);
}

TEST(OdometryAccumulator, LosesNothingBetweenFrames) {
  OdometryAccumulator way;
  way.add({0, 0, 0, 0});
  way.take(0);
  double sum = 0;
  for (int i = 1; i <= 100; ++i) {
    way.add({0.02 * i, 0.01 * i, 0, 0});
    if (i % 7 == 0) sum += way.take(0.02 * i + 0.01)->distance;
  }
  sum += way.take(2.0)->distance;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(OdometryAccumulator, KnowsNothingWithoutOdometryNearTheFrame) {
  OdometryAccumulator way;
  EXPECT_FALSE(way.take(0));
  way.add({0, 0, 0, 0});
  EXPECT_FALSE(way.take(10));
  way.add({10, 1, 0, 0});
  EXPECT_FALSE(way.take(10));  // the path before it is not known
  EXPECT_TRUE(way.take(10.1));
  EXPECT_FALSE(way.take(11));
}

TEST(OdometryAccumulator, PosesThatAreNotNumbersAreIgnored) {
  OdometryAccumulator way;
  way.add({0, 0, 0, 0});
  way.take(0);
  way.add({0.1, kNaN, 0, 0});
  way.add({0.1, 0, std::numeric_limits<double>::infinity(), 0});
  way.add({0.1, 0, 0, kNaN});
  way.add({kNaN, 0, 0, 0});
  way.add({0.2, 0.5, 0, 0});
  const auto motion = way.take(0.2);
  ASSERT_TRUE(motion);
  EXPECT_DOUBLE_EQ(motion->distance, 0.5);
}

TEST(OdometryAccumulator, AJumpRestartsIt) {
  OdometryAccumulator way;
  for (const OdometryPose& jump : {OdometryPose{0.1, 50, 0, 0}, OdometryPose{-5, 0, 0, 0}}) {
    way.add({0, 0, 0, 0});
    way.take(0);
    way.add(jump);
    EXPECT_FALSE(way.take(jump.stamp));
    way.add({jump.stamp + 0.1, jump.x + 0.2, 0, 0});
    const auto motion = way.take(jump.stamp + 0.1);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->distance, 0.2, 1e-12);
  }
}

}  // namespace
}  // namespace place_recognition
