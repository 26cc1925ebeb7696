#include "labels/room_polygons.h"

#include <utility>

#include "base/options.h"
#include "base/place_name.h"
#include "base/text.h"
#include "labels/labels.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Maximum number of corners of a room: the search for crossing walls takes quadratic time.
constexpr std::size_t kMaxCorners = 10000;
/// Largest coordinate, m: that of UTM.
constexpr double kMaxCoordinate = 1e7;
/// The smallest area of a room, m^2.
constexpr double kMinArea = 1e-4;

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

std::string cornerText(const Eigen::Vector2d& corner) {
  return "[" + shortest(corner.x()) + ", " + shortest(corner.y()) + "]";
}

/// Normalizes an outline drawn by a person: the last corner may repeat the first, and a corner may
/// occur twice.
Polygon toOutline(const PlaceEntry& entry, const std::string& where) {
  Polygon outline;
  for (const std::vector<double>& corner : entry.position) {
    if (corner.size() != 2) throw Error(where + ": a corner is not of the form [x, y].");
    const Eigen::Vector2d point(corner[0], corner[1]);
    if (!(point.cwiseAbs().maxCoeff() <= kMaxCoordinate)) {
      throw Error(where + ": the corner " + cornerText(point) +
                  " is more than 10,000 km from the origin of the map; give metres.");
    }
    if (outline.empty() || outline.back() != point) outline.push_back(point);
  }
  if (outline.size() > 1 && outline.back() == outline.front()) outline.pop_back();
  return outline;
}

std::string edgeText(const Polygon& outline, std::size_t edge) {
  return cornerText(outline[edge]) + " to " + cornerText(outline[(edge + 1) % outline.size()]);
}

void checkOutline(const Polygon& outline, const std::string& where) {
  if (outline.size() < 3) throw Error(where + ": a room needs at least three corners.");
  if (outline.size() > kMaxCorners) {
    throw Error(where + " has " + std::to_string(outline.size()) + " corners; give at most " +
                std::to_string(kMaxCorners) + ".");
  }
  if (const auto edges = crossingEdges(outline)) {
    throw Error(where + ": the wall from " + edgeText(outline, edges->first) +
                " crosses that from " + edgeText(outline, edges->second) +
                "; give the corners in the order of a walk around the room.");
  }
  if (!(areaOf(outline) >= kMinArea)) {
    throw Error(where + ": the corners enclose no area.");
  }
}

RoomPolygon toPolygon(const PlaceEntry& entry, const std::string& where) {
  checkLabel(entry.name, where);
  RoomPolygon room{placeName(entry.name), toOutline(entry, where)};
  checkOutline(room.corners, where);
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

std::optional<UniformDistribution> RoomPolygons::anywhereIn(const std::string& name) const {
  std::vector<UniformDistribution> parts;
  for (const RoomPolygon& room : rooms_) {
    if (room.name == name) parts.push_back(uniformDistribution(room.corners));
  }
  if (parts.empty()) return std::nullopt;
  return uniformDistribution(parts);
}

RoomPolygons readRoomPolygons(const std::string& path) {
  PlacesFile file;
  readOptions(readYamlFile(path), path, file);
  if (file.places.empty()) {
    throw Error(path +
                " does not name a room; give 'places: [{name: ..., position: [[x, y], ...]}]'.");
  }
  std::vector<RoomPolygon> rooms;
  for (std::size_t i = 0; i < file.places.size(); ++i) {
    rooms.push_back(toPolygon(file.places[i], path + ", places[" + std::to_string(i) + "]"));
  }
  return RoomPolygons(std::move(rooms));
}

}  // namespace place_recognition
