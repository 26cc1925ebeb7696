#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <string>
#include <vector>

#include "labels/room_polygons.h"

namespace place_recognition {

/// The rooms on the map for rviz: each polygon's outline, and its area, whose opacity increases
/// with the room's probability. Each room's name is shown once, in its largest polygon.
class RoomMarkers {
 public:
  /// The corners of `rooms` are in the tf frame `frame`.
  RoomMarkers(const RoomPolygons& rooms, const std::string& frame);

  /// `probabilityOf` returns the probability of a room, 0..1. The markers replace those of the last
  /// call.
  visualization_msgs::MarkerArray at(
      const std::function<double(const std::string&)>& probabilityOf) const;

 private:
  struct OfRoom {
    std::string room;
    visualization_msgs::Marker marker;
  };

  std::vector<visualization_msgs::Marker> outlines_;
  std::vector<OfRoom> areas_;
  std::vector<OfRoom> names_;
};

}  // namespace place_recognition
