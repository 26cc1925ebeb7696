#include <algorithm>
#include <cassert>

#include "simulation/building.h"

namespace place_recognition::simulation {
namespace {

constexpr float kQuarterTurn = 1.57079633f;

float squaredDistance(const cv::Rect2f& floor, float x, float y) {
  const float dx = std::max({floor.x - x, 0.0f, x - floor.x - floor.width});
  const float dy = std::max({floor.y - y, 0.0f, y - floor.y - floor.height});
  return dx * dx + dy * dy;
}

}  // namespace

const std::vector<Room>& rooms() {
  static const std::vector<Room> kRooms = {
      {"office_a", {0.0f, 2.4f, 4.2f, 4.6f}, 2.7f},
      {"office_b", {4.4f, 2.4f, 5.6f, 4.6f}, 2.7f},
      {"kitchen", {0.0f, -4.8f, 6.0f, 4.6f}, 2.7f},
      {"corridor", {0.0f, 0.0f, 12.0f, 2.2f}, 2.6f},
      {"printer_area", {12.0f, -2.2f, 4.6f, 4.4f}, 2.6f},
  };
  return kRooms;
}

const std::vector<Opening>& openings() {
  static const std::vector<Opening> kOpenings = {
      {Opening::kDoor, {2.9f, 2.2f, 0.9f, 0.2f}, 0.0f, 2.1f},
      {Opening::kDoor, {6.6f, 2.2f, 0.9f, 0.2f}, 0.0f, 2.1f},
      {Opening::kPane, {7.7f, 2.2f, 1.0f, 0.2f}, 0.25f, 2.1f},
      {Opening::kSlidingDoor, {3.2f, -0.2f, 2.2f, 0.2f}, 0.0f, 2.2f},
      {Opening::kPassage, {12.0f, 0.0f, 0.0f, 2.2f}, 0.0f, 2.6f},
      {Opening::kWindow, {0.7f, 7.0f, 2.8f, 0.3f}, 0.85f, 2.25f},
      {Opening::kWindow, {4.9f, 7.0f, 2.0f, 0.3f}, 0.85f, 2.25f},
      {Opening::kWindow, {7.5f, 7.0f, 2.0f, 0.3f}, 0.85f, 2.25f},
      {Opening::kWindow, {-0.3f, 0.45f, 0.3f, 1.3f}, 0.7f, 2.2f},
      {Opening::kWindow, {-0.3f, -4.3f, 0.3f, 1.7f}, 0.95f, 2.25f},
      {Opening::kWindow, {-0.3f, -2.2f, 0.3f, 1.7f}, 0.95f, 2.25f},
      {Opening::kWindow, {13.0f, 2.2f, 2.8f, 0.3f}, 0.8f, 2.2f},
  };
  return kOpenings;
}

const Room& room(const std::string& name) {
  const auto found = std::find_if(rooms().begin(), rooms().end(),
                                  [&](const Room& room) { return room.name == name; });
  assert(found != rooms().end());
  return *found;
}

const Room& roomAt(double x, double y) {
  const auto distance = [&](const Room& room) {
    return squaredDistance(room.floor, static_cast<float>(x), static_cast<float>(y));
  };
  return *std::min_element(rooms().begin(), rooms().end(),
                           [&](const Room& a, const Room& b) { return distance(a) < distance(b); });
}

Placement against(const Room& room, Side side, float along, float off, float z) {
  const cv::Rect2f& f = room.floor;
  switch (side) {
    case Side::kMinusY:
      return {f.x + along, f.y + off, z, 2.0f * kQuarterTurn};
    case Side::kPlusY:
      return {f.x + along, f.y + f.height - off, z, 0.0f};
    case Side::kMinusX:
      return {f.x + off, f.y + along, z, kQuarterTurn};
    case Side::kPlusX:
      break;
  }
  return {f.x + f.width - off, f.y + along, z, -kQuarterTurn};
}

}  // namespace place_recognition::simulation
