#include <algorithm>
#include <cmath>

#include "simulation/building.h"
#include "simulation/furnishing.h"

namespace place_recognition::simulation {
namespace {

/// What is likely under a condition.
struct Habits {
  float tube, shade;  ///< fraction of the lamps that are on
  float blind_drawn;  ///< fraction of the windows with a lowered blind
  float screen, seated;
  int walkers;
};

Habits habitsOf(Condition condition) {
  switch (condition) {
    case Condition::kSunny:
      return {0.35f, 0.0f, 0.4f, 0.8f, 0.15f, 3};
    case Condition::kNight:
      return {1.0f, 1.0f, 0.1f, 0.4f, 0.05f, 1};
    case Condition::kCloudy:
      break;
  }
  return {0.7f, 0.5f, 0.1f, 0.8f, 0.15f, 3};
}

bool clear(const Footprint& footprint, const std::vector<cv::Point2f>& points, float distance) {
  return std::none_of(points.begin(), points.end(), [&](const cv::Point2f& point) {
    return footprint.distance(point.x, point.y) < distance;
  });
}

void addLamps(Furniture& f, const Habits& habits) {
  const auto tubes = [&](const char* name, int columns, int rows, float yaw) {
    const Room& r = room(name);
    const bool on = f.random().chance(habits.tube);
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(columns);
        const float y = (static_cast<float>(j) + 0.5f) / static_cast<float>(rows);
        f.tube({r.floor.x + x * r.floor.width, r.floor.y + y * r.floor.height, r.height, yaw}, on);
      }
    }
  };
  const float quarter = 1.5707963f;
  tubes("office_a", 1, 2, 0.0f);
  tubes("office_b", 2, 2, quarter);
  tubes("kitchen", 2, 2, 0.0f);
  tubes("corridor", 5, 1, 0.0f);
  tubes("printer_area", 2, 1, quarter);
  f.pendant({1.9f, -2.3f, 2.7f, 0.0f}, 1.1f, f.random().chance(habits.shade));
  f.floorLamp({6.5f, 2.75f, 0.0f, 0.0f}, f.random().chance(habits.shade));
  f.floorLamp(against(room("office_a"), Side::kPlusX, 4.2f, 0.95f),
              f.random().chance(habits.shade));
}

void addBlinds(Furniture& f, const Habits& habits) {
  for (const Opening& opening : openings()) {
    if (opening.kind != Opening::kWindow) continue;
    const cv::Rect2f& g = opening.gap;
    const bool along_x = g.width > g.height;
    const float width = (along_x ? g.width : g.height) - 0.06f;
    const float full = opening.head - opening.sill;
    const float drop = f.random().chance(habits.blind_drawn) ? f.random().uniform(0.4f, 0.9f)
                                                             : f.random().uniform(0.04f, 0.15f);
    const Placement at =
        along_x ? Placement{g.x + g.width / 2.0f, g.y + 0.06f, opening.head, 0.0f}
                : Placement{g.x + g.width - 0.06f, g.y + g.height / 2.0f, opening.head, 1.5707963f};
    f.blind(at, width, full * drop, f.palette().blinds[0]);
  }
}

/// Opens doors to varying degrees, into the room, hinged on the side of larger x.
void addDoors(Furniture& f) {
  for (const Opening& opening : openings()) {
    if (opening.kind != Opening::kDoor) continue;
    const cv::Rect2f& g = opening.gap;
    const float open = f.random().uniform(1.45f, 1.75f);
    f.doorLeaf({g.x + g.width - 0.06f, g.y + g.height + 0.03f, 0.0f, 3.14159265f - open},
               g.width - 0.12f, true);
  }
}

void addChair(Furniture& f, const Seat& seat, const std::vector<cv::Point2f>& keep_clear) {
  const int fabric = f.pick(f.palette().fabrics);
  for (int attempt = 0; attempt < 8; ++attempt) {
    const Placement at = seat.at.moved(0.12f * f.random().normal(), 0.12f * f.random().normal(),
                                       0.0f, (seat.office ? 0.7f : 0.25f) * f.random().normal());
    if (!clear({at, 0.25f, -0.25f, 0.25f}, keep_clear, 0.2f)) continue;
    seat.office ? f.officeChair(at, fabric) : f.chair(at, f.palette().woods[0], fabric);
    return;
  }
}

void addSeats(Furniture& f, const Habits& habits, const std::vector<cv::Point2f>& keep_clear) {
  const std::vector<Seat> seats = f.seats;
  for (const Seat& seat : seats) {
    if (f.random().chance(habits.seated)) {
      f.officeChair(seat.at, f.palette().fabrics[0]);
      f.person(seat.at, true);
    } else if (f.random().chance(0.9f)) {
      addChair(f, seat, keep_clear);
    }
  }
}

void addClutter(Furniture& f, const Habits& habits) {
  const std::vector<Placement> computers = f.computers;
  for (const Placement& at : computers) f.computer(at, f.random().chance(habits.screen));
  const std::vector<Top> tops = f.tops;
  for (const Top& top : tops) {
    for (int i = f.random().integer(5); i > 0; --i) {
      const Placement at = top.at.moved(top.half_width * f.random().uniform(-1.0f, 1.0f),
                                        top.half_depth * f.random().uniform(-1.0f, 1.0f), 0.0f,
                                        f.random().uniform(0.0f, 6.28f));
      switch (f.random().integer(4)) {
        case 0:
          f.mug(at);
          break;
        case 1:
          f.bookPile(at, 1 + f.random().integer(4));
          break;
        default:
          f.sheets(at, 1 + f.random().integer(5));
          break;
      }
    }
  }
}

/// Places a thing of half size `half` anywhere on the free floor; `put` builds it at a placement.
template <typename Put>
void scatter(Furniture& f, int count, float half, const std::vector<cv::Point2f>& keep_clear,
             const Put& put) {
  for (int attempt = 0; attempt < 60 * count && count > 0; ++attempt) {
    const Room& r = rooms()[static_cast<std::size_t>(f.random().integer(5))];
    const Placement at{r.floor.x + half + f.random().uniform() * (r.floor.width - 2.0f * half),
                       r.floor.y + half + f.random().uniform() * (r.floor.height - 2.0f * half),
                       0.0f, f.random().uniform(0.0f, 6.28f)};
    const bool free = std::none_of(
        f.footprints.begin(), f.footprints.end(),
        [&](const Footprint& other) { return other.distance(at.x, at.y) < half + 0.05f; });
    if (!free || !clear({at, half, -half, half}, keep_clear, 0.3f)) continue;
    put(at);
    --count;
  }
}

}  // namespace

void addChanges(Furniture& furniture, Condition condition,
                const std::vector<cv::Point2f>& keep_clear) {
  const Habits habits = habitsOf(condition);
  addLamps(furniture, habits);
  addBlinds(furniture, habits);
  addDoors(furniture);
  addSeats(furniture, habits, keep_clear);
  addClutter(furniture, habits);
  scatter(furniture, habits.walkers, 0.25f, keep_clear,
          [&](const Placement& at) { furniture.person(at, false); });
  scatter(furniture, 3, 0.25f, keep_clear,
          [&](const Placement& at) { furniture.cardboardBox(at, 0.4f); });
  scatter(furniture, 2, 0.15f, keep_clear,
          [&](const Placement& at) { furniture.bin(at, furniture.palette().black); });
}

}  // namespace place_recognition::simulation
