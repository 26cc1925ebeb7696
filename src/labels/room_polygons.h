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

  /// The room that contains `point`. Empty if it is in none, in several with different names, or
  /// closer than `margin`, m, to the border of its polygon, where doorways are.
  std::string at(const Eigen::Vector2d& point, double margin) const;

  /// The distribution of a position of which only the room is known: uniform over the room's
  /// polygons, m. Nothing if no polygon has that name.
  std::optional<UniformDistribution> anywhereIn(const std::string& name) const;

  const std::vector<RoomPolygon>& polygons() const { return rooms_; }
  /// The name of each polygon, in the order of the file.
  std::vector<std::string> names() const;
  std::size_t size() const { return rooms_.size(); }

 private:
  std::vector<RoomPolygon> rooms_;
};

/// Reads a file in the format of the package semantic_pose:
///
///     places:
///       - name: kitchen
///         position: [[0, 0], [4.2, 0], [4.2, 3.1], [0, 3.1]]   # corners, m, in the map frame
///
/// Names are normalized by placeName(). Throws Error, naming the faulty place, also for an outline
/// that crosses itself or has no area.
RoomPolygons readRoomPolygons(const std::string& path);

}  // namespace place_recognition
