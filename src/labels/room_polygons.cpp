#include "labels/room_polygons.h"

#include <algorithm>
#include <limits>

#include "base/options.h"
#include "base/place_name.h"
#include "labels/labels.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

struct PlaceEntry {
  std::string name;
  std::vector<std::vector<double>> position;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("name", self.name, "label");
    visitor("position", self.position, "corners [x, y], m");
  }
};

struct PlacesFile {
  std::vector<PlaceEntry> places;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("places", self.places, "rooms");
  }
};

/// Calls visit(a, b) for each edge of the polygon.
template <typename Visit>
void forEachEdge(const std::vector<Eigen::Vector2d>& corners, Visit visit) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    visit(corners[i], corners[(i + 1) % corners.size()]);
  }
}

/// Whether a ray from `point` along x crosses the border an odd number of times.
bool contains(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point) {
  bool inside = false;
  forEachEdge(corners, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    if ((a.y() > point.y()) == (b.y() > point.y())) return;
    const double share = (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < a.x() + share * (b.x() - a.x())) inside = !inside;
  });
  return inside;
}

double distanceToBorder(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  forEachEdge(corners, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d edge = b - a;
    const double length = edge.squaredNorm();
    const double share = length > 0 ? std::clamp((point - a).dot(edge) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + share * edge - point).norm());
  });
  return nearest;
}

RoomPolygon toPolygon(const PlaceEntry& entry, const std::string& where) {
  checkNewLabel(entry.name, where);
  RoomPolygon room{placeName(entry.name), {}};
  for (const std::vector<double>& corner : entry.position) {
    if (corner.size() != 2) throw Error(where + ": a corner is not of the form [x, y].");
    room.corners.emplace_back(corner[0], corner[1]);
  }
  if (room.corners.size() < 3) throw Error(where + ": a room has three corners or more.");
  return room;
}

}  // namespace

std::string RoomPolygons::at(const Eigen::Vector2d& point, double margin) const {
  std::string name;
  for (const RoomPolygon& room : rooms_) {
    if (!contains(room.corners, point)) continue;
    const bool in_two = !name.empty() && name != room.name;
    if (in_two || distanceToBorder(room.corners, point) < margin) return "";
    name = room.name;
  }
  return name;
}

std::vector<std::string> RoomPolygons::names() const {
  std::vector<std::string> names;
  for (const RoomPolygon& room : rooms_) names.push_back(room.name);
  return names;
}

RoomPolygons readRoomPolygons(const std::string& path) {
  PlacesFile file;
  readOptions(readYamlFile(path), path, file);
  if (file.places.empty()) {
    throw Error(path + " names no room; give 'places: [{name: ..., position: [[x, y], ...]}]'.");
  }
  std::vector<RoomPolygon> rooms;
  for (std::size_t i = 0; i < file.places.size(); ++i) {
    rooms.push_back(toPolygon(file.places[i], path + ", places[" + std::to_string(i) + "]"));
  }
  return RoomPolygons(std::move(rooms));
}

}  // namespace place_recognition
