#include "ros/recognizer/camera_clocks.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

CameraClocks::Arrival at(double seconds) {
  return CameraClocks::Arrival(std::chrono::milliseconds(static_cast<int>(1000 * seconds)));
}

TEST(CameraClocks, ThatAgreeAreNotReported) {
  CameraClocks clocks(2);
  for (double t = 100; t < 110; t += 0.3) {
    EXPECT_FALSE(clocks.add(0, t, at(t)));
    EXPECT_FALSE(clocks.add(1, t - 0.2, at(t + 0.1)));
  }
}

TEST(CameraClocks, ThatDifferAreReported) {
  CameraClocks clocks(3);
  EXPECT_FALSE(clocks.add(0, 100, at(5)));
  EXPECT_FALSE(clocks.add(1, 100.1, at(5.1)));
  const auto difference = clocks.add(2, 80.2, at(5.2));
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->other, 0u);
  EXPECT_NEAR(difference->seconds, -20, 1e-9);
  EXPECT_NEAR(clocks.add(1, 100.3, at(5.3))->seconds, 20, 1e-9);
}

TEST(CameraClocks, ACameraThatHasBeenSilentIsNotCompared) {
  CameraClocks clocks(2);
  EXPECT_FALSE(clocks.add(0, 100, at(5)));
  EXPECT_FALSE(clocks.add(1, 500, at(9)));
}

}  // namespace
}  // namespace place_recognition
