#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "simulation/palette.h"
#include "simulation/scene.h"

namespace place_recognition::simulation {

/// A rectangular room; its floor is at z = 0.
struct Room {
  std::string name;
  cv::Rect2f floor;  ///< m
  float height;      ///< m
};

/// A hole in a wall.
struct Opening {
  enum Kind { kDoor, kSlidingDoor, kPane, kPassage, kWindow };
  Kind kind;
  cv::Rect2f gap;    ///< m, in plan: as long as the hole and as deep as the wall
  float sill, head;  ///< m
};

/// The side of a room at which a wall stands, seen from the room's middle.
enum class Side { kMinusY, kPlusX, kPlusY, kMinusX };

/// The plan, the same in every building: two offices on one side of a corridor, the kitchen on the
/// other, the printer area at its end. The outer walls face -x and +y.
const std::vector<Room>& rooms();
const std::vector<Opening>& openings();
const Room& room(const std::string& name);

/// The room at a point, or the nearest one.
const Room& roomAt(double x, double y);

/// Places a thing with its back to a wall, `along` metres from the wall's lower end and `off`
/// metres from the wall; its -y faces the room.
Placement against(const Room& room, Side side, float along, float off = 0.0f, float z = 0.0f);

/// Walls, floors, ceilings, window and door frames, skirting boards, glass, and what is outside.
void addShell(Scene& scene, const Palette& palette);

}  // namespace place_recognition::simulation
