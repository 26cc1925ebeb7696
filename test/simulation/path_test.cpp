#include "simulation/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "simulation/building.h"
#include "simulation/furnishing.h"

namespace place_recognition::simulation {
namespace {

/// Returns the floor area that a building's furniture occupies.
const std::vector<Footprint>& footprints() {
  static const std::vector<Footprint> kFootprints = [] {
    Scene scene;
    const Palette palette = makePalette(scene, 1, Condition::kCloudy);
    Furniture furniture(scene, palette, Random(1));
    furnish(furniture);
    return furniture.footprints;
  }();
  return kFootprints;
}

TEST(Markers, StandOnTheFreeFloorOfTheirRoomAboutAMetreApart) {
  const std::vector<Marker> all = markers(footprints());
  for (const Marker& marker : all) {
    const cv::Rect2f& floor = room(marker.room).floor;
    EXPECT_TRUE(floor.contains(marker.at)) << marker.room << marker.number;
    for (const Footprint& footprint : footprints()) {
      EXPECT_GT(footprint.distance(marker.at.x, marker.at.y), 0.3f);
    }
    for (const Marker& other : all) {
      if (&other == &marker) continue;
      EXPECT_GT(cv::norm(other.at - marker.at), 0.9);
    }
  }
}

TEST(TripodRun, TurnsClockwiseByThirtyDegrees) {
  const std::vector<Pose> recording = tripodRun({{"kitchen", 3, {1.0f, -2.0f}}}, 5.0, Random(1));
  ASSERT_EQ(recording.size(), 12u);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double expected = -static_cast<double>(i) * CV_PI / 6.0;
    EXPECT_NEAR(std::remainder(recording[i].view.yaw - expected, 2.0 * CV_PI), 0.0, 0.12);
    EXPECT_NEAR(recording[i].view.eye[0], 1.0f, 0.08f);
    EXPECT_NEAR(recording[i].view.eye[1], -2.0f, 0.08f);
    EXPECT_FLOAT_EQ(recording[i].view.eye[2], 0.76f);
    EXPECT_DOUBLE_EQ(recording[i].stamp, 0.2 * static_cast<double>(i));
  }
  EXPECT_EQ(recording[4].name, "kitchen_03_120");
}

TEST(DriveRun, IsContinuousAndNoFasterThanTheRobot) {
  const double rate = 5.0;
  const std::vector<Pose> recording = driveRun(rate, 0.0f, Random(1));
  for (std::size_t i = 1; i < recording.size(); ++i) {
    const Vec3 step = recording[i].view.eye - recording[i - 1].view.eye;
    EXPECT_LT(cv::norm(step), 1.02 * 0.5 / rate) << recording[i].name;
    const double turn =
        std::remainder(recording[i].view.yaw - recording[i - 1].view.yaw, 2.0 * CV_PI);
    EXPECT_LT(std::abs(turn), 0.7 / rate + 1e-3) << recording[i].name;
    EXPECT_NEAR(recording[i].stamp - recording[i - 1].stamp, 1.0 / rate, 1e-9);
  }
}

TEST(DriveRun, VisitsEveryRoomAndReturnsToTheCorridor) {
  for (const float stray : {0.0f, 0.1f}) {
    std::map<std::string, int> visits;
    std::string last;
    for (const Pose& pose : driveRun(5.0, stray, Random(1))) {
      if (pose.room != last) ++visits[pose.room];
      last = pose.room;
      const cv::Rect2f& floor = room(pose.room).floor;
      const float dx =
          std::max({floor.x - pose.view.eye[0], 0.0f, pose.view.eye[0] - floor.x - floor.width});
      const float dy =
          std::max({floor.y - pose.view.eye[1], 0.0f, pose.view.eye[1] - floor.y - floor.height});
      EXPECT_LE(std::hypot(dx, dy), 0.11f) << pose.name;  // half a wall, in a door
    }
    EXPECT_EQ(visits.size(), 5u);
    EXPECT_GE(visits["corridor"], 4);
  }
}

TEST(DriveRun, StraysByNoMoreThanItIsTold) {
  const std::vector<cv::Point2f> way = driveWay();
  double farthest = 0;
  for (const Pose& pose : driveRun(5.0, 0.1f, Random(1))) {
    double nearest = 1;
    for (const cv::Point2f& point : way) {
      nearest = std::min<double>(
          nearest, std::hypot(point.x - pose.view.eye[0], point.y - pose.view.eye[1]));
    }
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 0.15);
  EXPECT_GT(farthest, 0.03);
}

TEST(DriveWay, KeepsClearOfTheFurniture) {
  for (const cv::Point2f& point : driveWay()) {
    for (const Footprint& footprint : footprints()) {
      EXPECT_GT(footprint.distance(point.x, point.y), 0.2f) << point;
    }
  }
}

}  // namespace
}  // namespace place_recognition::simulation
