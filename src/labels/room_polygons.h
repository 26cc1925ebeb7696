#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "labels/polygon.h"

namespace place_recognition {

/// A room on the map.
struct RoomPolygon {
  std::string name;
  Polygon corners;  ///< m, in the map frame
};

/// The rooms of a building. Several polygons may have the same name.
class RoomPolygons {
 public:
  explicit RoomPolygons(std::vector<RoomPolygon> rooms) : rooms_(std::move(rooms)) {}

  /// The room that `point` lies in. Empty: in none, in several of different names, or nearer than
  /// `margin`, m, to the border of its polygon, where doorways are.
  std::string at(const Eigen::Vector2d& point, double margin) const;

  /// Where somebody is of whom only the room is known: anywhere in its polygons, m. Nothing if no
  /// polygon has that name.
  std::optional<UniformDistribution> anywhereIn(const std::string& name) const;

  const std::vector<RoomPolygon>& polygons() const { return rooms_; }
  /// The name of each polygon, in the order of the file.
  std::vector<std::string> names() const;
  std::size_t size() const { return rooms_.size(); }

 private:
  std::vector<RoomPolygon> rooms_;
};

/// Reads a file of the form that the package semantic_pose uses:
///
///     places:
///       - name: kitchen
///         position: [[0, 0], [4.2, 0], [4.2, 3.1], [0, 3.1]]   # corners, m, in the map frame
///
/// Names are read as placeName() has them. Throws Error, naming the place at fault, also for an
/// outline that crosses itself or encloses nothing.
RoomPolygons readRoomPolygons(const std::string& path);

}  // namespace place_recognition
