// From a room to a pose: when a room is certain, its pose, and the markers for rviz.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "ros/localization/held_room.h"
#include "ros/localization/room_markers.h"
#include "ros/messages/pose_conversions.h"

namespace place_recognition {
namespace {

using visualization_msgs::Marker;

/// Returns an answer with that probability for the room and a tenth of the rest for 'unknown'.
PlaceRecognition beliefIn(const std::string& room, double probability) {
  PlaceRecognition belief;
  belief.place = room;
  belief.known = true;
  belief.evidence = 1 - (1 - probability) / 10;
  belief.confidence = probability / belief.evidence;
  belief.places.resize(2);
  belief.places[0].name = room;
  belief.places[0].probability = belief.confidence;
  belief.places[1].name = "another";
  belief.places[1].probability = 1 - belief.confidence;
  return belief;
}

class RoomHeld : public testing::Test {
 protected:
  /// Returns the room that is certain after another answer, 0.5 s later.
  std::string add(const PlaceRecognition& belief) {
    now_ += ros::Duration(0.5);
    held_.add(belief, now_);
    EXPECT_EQ(held_.sureRoom(now_).empty(), !held_.whyNot(now_).empty());
    return held_.sureRoom(now_);
  }

  ros::Time now_{1000};
  HeldRoom held_{HeldRoom::Options{0.9, 1, 2}};
};

TEST_F(RoomHeld, IsSureWhenItHasBeenLikelyForLongEnough) {
  EXPECT_EQ(held_.whyNot(now_), "no answer of place_recognizer has arrived");
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
  EXPECT_EQ(held_.whyNot(now_), "'kitchen' has been certain for 0.00 s, less than ~hold");
  EXPECT_EQ(add(beliefIn("kitchen", 0.91)), "");
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "kitchen");
  EXPECT_EQ(add(beliefIn("kitchen", 0.85)), "");
  EXPECT_EQ(held_.whyNot(now_), "'kitchen' has a probability of 0.85, less than ~min_probability");
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "kitchen");
}

TEST_F(RoomHeld, IsNotSureAfterAnotherRoomOrUnknown) {
  PlaceRecognition unknown = beliefIn("kitchen", 0.95);
  unknown.known = false;
  for (const PlaceRecognition& other : {beliefIn("lab", 0.95), unknown}) {
    for (int i = 0; i < 3; ++i) add(beliefIn("kitchen", 0.95));
    EXPECT_EQ(add(other), "");
    EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
    EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
    EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "kitchen");
  }
  add(unknown);
  EXPECT_EQ(held_.whyNot(now_), "the answer is 'unknown'");
}

TEST_F(RoomHeld, CountsUnknownAgainstARoom) {
  PlaceRecognition belief = beliefIn("kitchen", 0.95);
  belief.confidence = 1;
  belief.evidence = 0.8;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(add(belief), "");
}

TEST_F(RoomHeld, IsNotSureWhenAnswersCease) {
  for (int i = 0; i < 3; ++i) add(beliefIn("kitchen", 0.95));
  EXPECT_EQ(held_.sureRoom(now_ + ros::Duration(1.9)), "kitchen");
  EXPECT_NEAR(held_.probabilityOf("kitchen", now_ + ros::Duration(1.9)), 0.95, 1e-12);
  now_ += ros::Duration(2.1);
  EXPECT_EQ(held_.sureRoom(now_), "");
  EXPECT_EQ(held_.whyNot(now_), "the last answer of place_recognizer arrived 2.10 s ago");
  EXPECT_EQ(held_.probabilityOf("kitchen", now_), 0);
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");  // it may have been elsewhere in between
}

TEST_F(RoomHeld, IsNotSureAfterTheClockIsSet) {
  for (int i = 0; i < 3; ++i) add(beliefIn("kitchen", 0.95));
  now_ = ros::Time(3e9);  // more than a ros::Duration later
  EXPECT_EQ(held_.sureRoom(now_), "");
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
}

TEST_F(RoomHeld, WaitsForeverWithoutATimeout) {
  held_ = HeldRoom(HeldRoom::Options{0.9, 1, 0});
  for (int i = 0; i < 3; ++i) add(beliefIn("kitchen", 0.95));
  now_ += ros::Duration(1e6);
  EXPECT_EQ(held_.sureRoom(now_), "kitchen");
  EXPECT_NEAR(held_.probabilityOf("kitchen", now_), 0.95, 1e-12);
}

TEST_F(RoomHeld, IsForgotten) {
  for (int i = 0; i < 3; ++i) add(beliefIn("kitchen", 0.95));
  held_.forget();
  EXPECT_EQ(held_.whyNot(now_), "no answer of place_recognizer has arrived");
  EXPECT_EQ(held_.probabilityOf("kitchen", now_), 0);
  EXPECT_EQ(add(beliefIn("kitchen", 0.95)), "");
}

TEST_F(RoomHeld, TellsTheProbabilityOfEachRoom) {
  add(beliefIn("kitchen", 0.6));
  EXPECT_NEAR(held_.probabilityOf("kitchen", now_), 0.6, 1e-12);
  EXPECT_NEAR(held_.probabilityOf("another", now_), 0.36, 1e-12);
  EXPECT_EQ(held_.probabilityOf("cellar", now_), 0);
}

TEST(RoomPoses, HaveTheMomentsOfTheRoomAndAnyHeading) {
  const Polygon room = {{1, 2}, {7, 2}, {7, 4}, {3, 4}, {3, 8}, {1, 8}};
  const UniformDistribution area = uniformDistribution(room);
  const geometry_msgs::PoseWithCovariance pose = toPose(area);
  EXPECT_EQ(positionOf(pose), area.mean);
  EXPECT_EQ(positionCovariance(pose), area.covariance);
  EXPECT_EQ(pose.pose.orientation.w, 1);
  // xx, xy, yx, yy and yaw-yaw, which amcl reads.
  EXPECT_EQ(pose.covariance[0], area.covariance(0, 0));
  EXPECT_EQ(pose.covariance[1], area.covariance(0, 1));
  EXPECT_EQ(pose.covariance[6], area.covariance(0, 1));
  EXPECT_EQ(pose.covariance[7], area.covariance(1, 1));
  EXPECT_NEAR(pose.covariance[35], M_PI * M_PI / 3, 1e-12);
  int others = 0;
  for (const double element : pose.covariance) others += element == 0 ? 1 : 0;
  EXPECT_EQ(others, 31);
}

TEST(RoomPoses, DeviateMostAlongTheLongerAxis) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int i = 0; i < 50; ++i) {
    Eigen::Matrix2d root;
    root << number(random), number(random), number(random), number(random);
    const Eigen::Matrix2d covariance = root * root.transpose();
    const double largest =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues().maxCoeff();
    EXPECT_NEAR(largestDeviation(covariance), std::sqrt(largest), 1e-9);
  }
  EXPECT_TRUE(std::isnan(largestDeviation(Eigen::Matrix2d::Constant(std::nan("")))));
}

/// A hall, and a kitchen of two polygons; the larger is a U whose centroid is outside of it.
RoomPolygons threePolygons() {
  return RoomPolygons(
      {{"kitchen", {{20, 0}, {21, 0}, {21, 1}, {20, 1}}},
       {"hall", {{0, 10}, {4, 10}, {4, 13}, {0, 13}}},
       {"kitchen", {{0, 0}, {9, 0}, {9, 9}, {8, 9}, {8, 1}, {1, 1}, {1, 9}, {0, 9}}}});
}

std::map<std::string, std::vector<Marker>> byKind(const visualization_msgs::MarkerArray& array) {
  std::map<std::string, std::vector<Marker>> kinds;
  for (const Marker& marker : array.markers) kinds[marker.ns].push_back(marker);
  return kinds;
}

double belief(const std::string& room) { return room == "hall" ? 0.25 : 0.75; }

Eigen::Vector2d flat(const geometry_msgs::Point& point) { return {point.x, point.y}; }

TEST(RoomsInRviz, AreOnTheMapWhereverThatIs) {
  for (const Marker& marker : RoomMarkers(threePolygons(), "map").at(belief).markers) {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_TRUE(marker.header.stamp.isZero());
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_EQ(marker.pose.orientation.w, 1);
    EXPECT_TRUE(marker.lifetime.isZero());
  }
}

TEST(RoomsInRviz, AreFilledByTheirProbability) {
  const RoomMarkers markers(threePolygons(), "map");
  const auto areas = byKind(markers.at(belief))["area"];
  ASSERT_EQ(areas.size(), 3u);
  const std::vector<RoomPolygon> rooms = threePolygons().polygons();
  for (std::size_t i = 0; i < areas.size(); ++i) {
    EXPECT_EQ(areas[i].type, Marker::TRIANGLE_LIST);
    ASSERT_EQ(areas[i].points.size() % 3, 0u);
    double area = 0;
    for (std::size_t k = 0; k < areas[i].points.size(); k += 3) {
      area += areaOf(
          {flat(areas[i].points[k]), flat(areas[i].points[k + 1]), flat(areas[i].points[k + 2])});
    }
    EXPECT_NEAR(area, areaOf(rooms[i].corners), 1e-9);
  }
  EXPECT_EQ(areas[0].color.a, areas[2].color.a);
  EXPECT_LT(areas[1].color.a, areas[0].color.a);
  const auto none = byKind(markers.at([](const std::string&) { return 0.0; }))["area"];
  const auto full = byKind(markers.at([](const std::string&) { return 1.0; }))["area"];
  EXPECT_GT(none[0].color.a, 0);
  EXPECT_LT(none[0].color.a, areas[1].color.a);
  EXPECT_LE(full[0].color.a, 1);
  EXPECT_GT(full[0].color.a, areas[0].color.a);
}

TEST(RoomsInRviz, HaveClosedOutlines) {
  const auto outlines = byKind(RoomMarkers(threePolygons(), "map").at(belief))["outline"];
  ASSERT_EQ(outlines.size(), 3u);
  for (const Marker& outline : outlines) {
    EXPECT_EQ(outline.type, Marker::LINE_STRIP);
    EXPECT_EQ(flat(outline.points.front()), flat(outline.points.back()));
  }
  EXPECT_EQ(outlines[2].points.size(), 9u);
}

TEST(RoomsInRviz, AreNamedOnceInsideTheirLargestPolygon) {
  const RoomPolygons rooms = threePolygons();
  const auto names = byKind(RoomMarkers(rooms, "map").at(belief))["name"];
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[0].text, "hall 25 %");
  EXPECT_EQ(names[1].text, "kitchen 75 %");
  EXPECT_EQ(flat(names[0].pose.position), Eigen::Vector2d(2, 11.5));
  EXPECT_TRUE(contains(rooms.polygons()[2].corners, flat(names[1].pose.position)));
  EXPECT_EQ(byKind(RoomMarkers(rooms, "map").at([](const std::string&) { return 0.004; }))["name"]
                .front()
                .text,
            "hall");
}

TEST(RoomsInRviz, ReplaceThoseBefore) {
  const RoomMarkers markers(threePolygons(), "map");
  const auto first = markers.at(belief).markers;
  const auto second = markers.at([](const std::string&) { return 0.5; }).markers;
  ASSERT_EQ(first.size(), second.size());
  std::map<std::pair<std::string, int>, int> count;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].ns, second[i].ns);
    EXPECT_EQ(first[i].id, second[i].id);
    EXPECT_EQ(++count[std::make_pair(first[i].ns, first[i].id)], 1);
  }
}

}  // namespace
}  // namespace place_recognition
