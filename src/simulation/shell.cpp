#include <algorithm>
#include <cmath>

#include "simulation/building.h"

namespace place_recognition::simulation {
namespace {

/// A wall of a room: distances are measured from its lower end in x or y.
struct Wall {
  const Room& room;
  Side side;

  bool alongX() const { return side == Side::kMinusY || side == Side::kPlusY; }
  float start() const { return alongX() ? room.floor.x : room.floor.y; }
  float length() const { return alongX() ? room.floor.width : room.floor.height; }
  /// The coordinate shared by all its points.
  float level() const {
    const cv::Rect2f& f = room.floor;
    switch (side) {
      case Side::kMinusY:
        return f.y;
      case Side::kPlusY:
        return f.y + f.height;
      case Side::kMinusX:
        return f.x;
      case Side::kPlusX:
        break;
    }
    return f.x + f.width;
  }

  bool has(const Opening& opening) const {
    const cv::Rect2f& g = opening.gap;
    const float low = alongX() ? g.y : g.x;
    const float high = low + (alongX() ? g.height : g.width);
    const float from = alongX() ? g.x : g.y;
    const bool across = alongX() ? g.width > g.height : g.height > g.width;
    const bool touches = std::min(std::abs(low - level()), std::abs(high - level())) < 0.01f;
    return across && touches && from >= start() - 0.01f && from < start() + length();
  }
};

/// The part of a wall from `from` to `to` metres along it, `low` to `high` above the floor.
void addPanel(Scene& scene, const Wall& wall, float from, float to, float low, float high,
              int material) {
  if (to - from < 0.01f || high - low < 0.01f) return;
  Placement at = against(wall.room, wall.side, (from + to) / 2.0f, 0.0f, low);
  scene.picture(at, to - from, high - low, material);
}

void addSkirting(Scene& scene, const Wall& wall, float from, float to, int material) {
  const float half = (to - from) / 2.0f;
  scene.box(against(wall.room, wall.side, (from + to) / 2.0f), {-half, -0.012f, 0.0f},
            {half, 0.0f, 0.08f}, material);
}

void addWall(Scene& scene, const Palette& palette, const Wall& wall, int paint) {
  std::vector<Opening> holes;
  for (const Opening& opening : openings()) {
    if (wall.has(opening)) holes.push_back(opening);
  }
  const auto from = [&](const Opening& o) {
    return (wall.alongX() ? o.gap.x : o.gap.y) - wall.start();
  };
  const auto width = [&](const Opening& o) { return wall.alongX() ? o.gap.width : o.gap.height; };
  std::sort(holes.begin(), holes.end(),
            [&](const Opening& a, const Opening& b) { return from(a) < from(b); });

  const float top = wall.room.height;
  float done = 0.0f;
  const auto solid = [&](float to) {
    addPanel(scene, wall, done, to, 0.0f, top, paint);
    if (to - done > 0.05f) addSkirting(scene, wall, done, to, palette.skirting);
  };
  for (const Opening& hole : holes) {
    solid(from(hole));
    addPanel(scene, wall, from(hole), from(hole) + width(hole), 0.0f, hole.sill, paint);
    addPanel(scene, wall, from(hole), from(hole) + width(hole), hole.head, top, paint);
    done = from(hole) + width(hole);
  }
  solid(wall.length());
}

/// In the frame of an opening, x runs along the wall from -half to half, and y through it.
struct Gap {
  Placement at;
  float half, depth;
};

Gap gapOf(const Opening& opening) {
  const cv::Rect2f& g = opening.gap;
  const bool along_x = g.width > g.height;
  // In the frame of an outer wall, y points inside.
  const float yaw = along_x ? 3.14159265f : -1.57079633f;
  return {{g.x + g.width / 2.0f, g.y + g.height / 2.0f, 0.0f, yaw},
          (along_x ? g.width : g.height) / 2.0f,
          along_x ? g.height : g.width};
}

/// Lines the hole with four boards and adds a frame `bar` wide in its middle.
void addFrame(Scene& scene, const Opening& opening, float bar, int lining, int frame) {
  const Gap gap = gapOf(opening);
  const float y = gap.depth / 2.0f, thin = 0.004f;
  const float low = opening.sill, high = opening.head;
  scene.box(gap.at, {-gap.half, -y, low}, {-gap.half + thin, y, high}, lining);
  scene.box(gap.at, {gap.half - thin, -y, low}, {gap.half, y, high}, lining);
  scene.box(gap.at, {-gap.half, -y, high - thin}, {gap.half, y, high}, lining);
  if (low > 0.0f) scene.box(gap.at, {-gap.half, -y, low}, {gap.half, y, low + thin}, lining);
  scene.box(gap.at, {-gap.half, -0.03f, low}, {-gap.half + bar, 0.03f, high}, frame);
  scene.box(gap.at, {gap.half - bar, -0.03f, low}, {gap.half, 0.03f, high}, frame);
  scene.box(gap.at, {-gap.half, -0.03f, high - bar}, {gap.half, 0.03f, high}, frame);
  if (low > 0.0f) scene.box(gap.at, {-gap.half, -0.03f, low}, {gap.half, 0.03f, low + bar}, frame);
}

void addGlass(Scene& scene, const Palette& palette, const Placement& at, float width, float low,
              float high) {
  scene.picture(at.moved(0, 0, low), width, high - low, palette.glass).two_sided = true;
}

void addWindow(Scene& scene, const Palette& palette, const Opening& opening) {
  const Gap gap = gapOf(opening);
  const float low = opening.sill, high = opening.head;
  addFrame(scene, opening, 0.06f, palette.frame, palette.frame);
  addGlass(scene, palette, gap.at, 2.0f * gap.half, low, high);
  const int panes = std::max(2, static_cast<int>(std::lround(gap.half * 2.0f / 0.9f)));
  for (int i = 1; i < panes; ++i) {
    const float x = -gap.half + 2.0f * gap.half * static_cast<float>(i) / static_cast<float>(panes);
    scene.box(gap.at, {x - 0.04f, -0.03f, low}, {x + 0.04f, 0.03f, high}, palette.frame);
  }
  const float inner = gap.depth / 2.0f;
  scene.box(gap.at, {-gap.half - 0.06f, inner - 0.02f, low - 0.04f},
            {gap.half + 0.06f, inner + 0.14f, low}, palette.porcelain);

  Window window;
  const float clear = 0.04f;  // of the frame, but behind the blind
  window.centre = gap.at(0.0f, clear, (low + high) / 2.0f);
  window.half_u = gap.at(gap.half, clear, (low + high) / 2.0f) - window.centre;
  window.half_v = Vec3(0.0f, 0.0f, (high - low) / 2.0f);
  window.normal = cv::normalize(gap.at(0.0f, 1.0f, 0.0f) - gap.at(0.0f, 0.0f, 0.0f));
  scene.windows.push_back(window);
}

/// One half is fixed, and the other is slid open behind it.
void addSlidingDoor(Scene& scene, const Palette& palette, const Opening& opening) {
  const Gap gap = gapOf(opening);
  addFrame(scene, opening, 0.05f, palette.frame, palette.steel);
  for (const float y : {-0.05f, 0.02f}) {
    const float from = -gap.half, to = 0.0f, high = opening.head - 0.05f;
    scene.box(gap.at, {from, y, 0.0f}, {from + 0.07f, y + 0.03f, high}, palette.steel);
    scene.box(gap.at, {to - 0.07f, y, 0.0f}, {to, y + 0.03f, high}, palette.steel);
    scene.box(gap.at, {from, y, 0.0f}, {to, y + 0.03f, 0.12f}, palette.steel);
    addGlass(scene, palette, gap.at.moved((from + to) / 2.0f, y), to - from, 0.1f, high);
  }
}

void addOpening(Scene& scene, const Palette& palette, const Opening& opening) {
  switch (opening.kind) {
    case Opening::kDoor:
      addFrame(scene, opening, 0.05f, palette.door, palette.door);
      break;
    case Opening::kSlidingDoor:
      addSlidingDoor(scene, palette, opening);
      break;
    case Opening::kWindow:
      addWindow(scene, palette, opening);
      break;
    case Opening::kPane:
      addFrame(scene, opening, 0.05f, palette.door, palette.door);
      addGlass(scene, palette, gapOf(opening).at, 2.0f * gapOf(opening).half, opening.sill,
               opening.head);
      break;
    case Opening::kPassage:
      break;
  }
}

/// Two painted walls 30 m away, because the building is an upper floor at a street corner.
void addOutdoors(Scene& scene, int material) {
  scene.picture({8.0f, 37.0f, -14.0f, 0.0f}, 120.0f, 32.0f, material);
  scene.picture({-30.0f, 0.0f, -14.0f, 1.57079633f}, 120.0f, 32.0f, material);
}

}  // namespace

void addShell(Scene& scene, const Palette& palette) {
  for (std::size_t i = 0; i < rooms().size(); ++i) {
    const Room& room = rooms()[i];
    const cv::Rect2f& f = room.floor;
    const float x0 = f.x, x1 = f.x + f.width, y0 = f.y, y1 = f.y + f.height, top = room.height;
    scene.polygon({{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, palette.floors[i]);
    scene.polygon({{x0, y1, top}, {x1, y1, top}, {x1, y0, top}, {x0, y0, top}}, palette.ceiling);
    for (const Side side : {Side::kMinusY, Side::kPlusX, Side::kPlusY, Side::kMinusX}) {
      addWall(scene, palette, {room, side}, palette.walls[i]);
    }
  }
  for (const Opening& opening : openings()) {
    const cv::Rect2f& g = opening.gap;
    // The threshold hides the ground between two floors.
    if (opening.sill == 0.0f && g.area() > 0.0f) {
      scene.box({}, {g.x, g.y, -0.05f}, {g.x + g.width, g.y + g.height, 0.0f}, palette.steel);
    }
    addOpening(scene, palette, opening);
  }
  addOutdoors(scene, palette.outdoors);
}

}  // namespace place_recognition::simulation
