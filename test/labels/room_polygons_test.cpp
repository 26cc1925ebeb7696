// Rooms on a map: the room of a point, and files that are refused.

#include "labels/room_polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "error_of.h"
#include "place_recognition/error.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

RoomPolygons roomsOf(const std::string& yaml) {
  const ScratchFolder scratch;
  return readRoomPolygons(scratch.write("rooms.yaml", yaml));
}

std::string errorIn(const std::string& yaml) {
  return errorOf([&] { roomsOf(yaml); });
}

/// Two rooms side by side, a wall (or doorway) at x = 4.
const char* const kTwoRooms =
    "places:\n"
    "  - name: kitchen\n"
    "    position: [[0, 0], [4, 0], [4, 3], [0, 3]]\n"
    "  - name: corridor\n"
    "    position: [[4, 3], [4, 0], [8, 0], [8, 3]]\n";

TEST(RoomPolygons, NameTheRoomAroundAPoint) {
  const RoomPolygons rooms = roomsOf(kTwoRooms);
  EXPECT_EQ(rooms.at({2, 1.5}, 0.3), "kitchen");
  EXPECT_EQ(rooms.at({6, 1.5}, 0.3), "corridor");
  EXPECT_EQ(rooms.at({9, 1.5}, 0.3), "");
  EXPECT_EQ(rooms.at({2, -1}, 0), "");
}

TEST(RoomPolygons, SayNothingNearABorder) {
  const RoomPolygons rooms = roomsOf(kTwoRooms);
  EXPECT_EQ(rooms.at({3.71, 1.5}, 0.3), "");
  EXPECT_EQ(rooms.at({3.69, 1.5}, 0.3), "kitchen");
  EXPECT_EQ(rooms.at({4.29, 1.5}, 0.3), "");
  EXPECT_EQ(rooms.at({4.31, 1.5}, 0.3), "corridor");
  EXPECT_EQ(rooms.at({3.99, 1.5}, 0), "kitchen");
}

TEST(RoomPolygons, OfNamesWrittenInTwoWaysAreOneRoom) {
  const RoomPolygons rooms = roomsOf(
      "places:\n"
      "  - name: 'K\u00fcche'\n"
      "    position: [[0, 0], [4, 0], [4, 3], [0, 3]]\n"
      "  - name: ' Ku\u0308che '\n"
      "    position: [[2, 0], [6, 0], [6, 3], [2, 3]]\n");
  for (const double x : {1.0, 3.0, 5.0}) EXPECT_EQ(rooms.at({x, 1.5}, 0.1), "K\u00fcche");
  EXPECT_EQ(rooms.names(), (std::vector<std::string>{"K\u00fcche", "K\u00fcche"}));
}

TEST(RoomPolygons, MayBeOfAnyShape) {
  // An L: the notch at the upper right is outside.
  const RoomPolygons rooms({{"hall", {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}}});
  EXPECT_EQ(rooms.at({5, 1}, 0.5), "hall");
  EXPECT_EQ(rooms.at({1, 5}, 0.5), "hall");
  EXPECT_EQ(rooms.at({4, 4}, 0), "");
  // At the inner corner, the distance is measured to the corner itself.
  EXPECT_EQ(rooms.at({1.6, 1.6}, 0.4 * std::sqrt(2.0) - 1e-9), "hall");
  EXPECT_EQ(rooms.at({1.6, 1.6}, 0.4 * std::sqrt(2.0) + 1e-9), "");
}

TEST(RoomPolygons, ThatOverlapSayNothingUnlessTheyAreOneRoom) {
  const std::vector<Eigen::Vector2d> left = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<Eigen::Vector2d> right = {{2, 0}, {6, 0}, {6, 4}, {2, 4}};
  EXPECT_EQ(RoomPolygons({{"a", left}, {"b", right}}).at({3, 2}, 0), "");
  EXPECT_EQ(RoomPolygons({{"a", left}, {"b", right}}).at({1, 2}, 0), "a");
  EXPECT_EQ(RoomPolygons({{"a", left}, {"a", right}}).at({3, 2}, 0), "a");
}

TEST(RoomPolygons, SayNothingOfAPointThatIsNone) {
  EXPECT_EQ(roomsOf(kTwoRooms).at({std::nan(""), 1}, 0.3), "");
  EXPECT_EQ(roomsOf(kTwoRooms).at({1, std::nan("")}, 0.3), "");
}

TEST(RoomPolygons, MayReturnToTheirFirstCorner) {
  const RoomPolygons rooms =
      roomsOf("places: [{name: a, position: [[0, 0], [4, 0], [4, 0], [4, 3], [0, 3], [0, 0]]}]");
  EXPECT_EQ(rooms.polygons().front().corners.size(), 4u);
}

TEST(RoomPolygons, OfOneNameAreOneArea) {
  const std::vector<Eigen::Vector2d> left = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const std::vector<Eigen::Vector2d> right = {{10, 0}, {10, 2}, {16, 2}, {16, 0}};
  const RoomPolygons rooms({{"a", left}, {"b", {{0, 0}, {9, 0}, {0, 9}}}, {"a", right}});
  const auto somewhere = rooms.anywhereIn("a");
  ASSERT_TRUE(somewhere);
  EXPECT_DOUBLE_EQ(somewhere->area, 16);
  // A quarter of it around x = 1, the rest around 13: 10, and 4/12 / 4 + 36/12 * 3/4 + 12^2 * 3/16.
  EXPECT_LT((somewhere->mean - Eigen::Vector2d(10, 1)).norm(), 1e-12);
  EXPECT_NEAR(somewhere->covariance(0, 0), 1. / 12 + 9. / 4 + 27, 1e-12);
  EXPECT_NEAR(somewhere->covariance(1, 1), 1. / 3, 1e-12);
  EXPECT_FALSE(rooms.anywhereIn("c"));
}

TEST(RoomPolygons, OfABadFileSayWhatIsWrong) {
  const auto expectError = [](const std::string& yaml, const std::string& reason) {
    EXPECT_NE(errorIn(yaml).find(reason), std::string::npos) << errorIn(yaml);
  };
  expectError("places: []", "does not name a room");
  expectError("rooms: []", "places");
  expectError("places: [{name: a, position: [[0, 0], [1, 0]]}]",
              "places[0]: a room needs at least three");
  expectError("places: [{name: a, position: [[0, 0], [1, 0], [1]]}]", "[x, y]");
  expectError("places: [{name: a, position: [[0, 0], [1, 0], [1, .nan]]}]", "finite");
  expectError("places: [{name: a, position: [[0, 0], [1, 0], [1, 1e300]]}]", "10,000 km");
  expectError("places: [{name: '', position: [[0, 0], [1, 0], [1, 1]]}]", "not a place name");
  expectError("places: [{name: unknown, position: [[0, 0], [1, 0], [1, 1]]}]", "unknown");
  expectError("places: [{name: a, position: [[0, 0], [1, 1], [0, 0]]}]",
              "a room needs at least three");
  expectError("places: [{name: a, position: [[0, 0], [1, 1], [2, 2]]}]", "enclose no area");
  expectError("places: [{name: a, position: [[0, 0], [4, 0], [0, 3], [4, 3]]}]",
              "places[0]: the wall from [4, 0] to [0, 3] crosses that from [4, 3] to [0, 0]; give");
  EXPECT_THROW(readRoomPolygons("/no/such/rooms.yaml"), Error);
}

}  // namespace
}  // namespace place_recognition
