#include "ros/localization/room_markers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/text.h"

namespace place_recognition {
namespace {

using visualization_msgs::Marker;

/// m above the map, so that neither hides the other.
constexpr double kAreaHeight = 0.01;
constexpr double kOutlineHeight = 0.02;
constexpr double kNameHeight = 0.1;
constexpr double kOutlineWidth = 0.04;  // m
/// Alpha of a room with probability 0, and its increase up to probability 1.
constexpr double kEmptyAlpha = 0.05;
constexpr double kFullAlpha = 0.75;

std_msgs::ColorRGBA color(double r, double g, double b, double a) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(r);
  color.g = static_cast<float>(g);
  color.b = static_cast<float>(b);
  color.a = static_cast<float>(a);
  return color;
}

geometry_msgs::Point pointAt(const Eigen::Vector2d& position, double height) {
  geometry_msgs::Point point;
  point.x = position.x();
  point.y = position.y();
  point.z = height;
  return point;
}

/// Without a stamp, so that rviz shows it at the current position of the map.
Marker markerOf(std::size_t polygon, const std::string& frame, const std::string& kind,
                std::int32_t type) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = kind;
  marker.id = static_cast<std::int32_t>(polygon);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1;
  return marker;
}

Marker outlineMarker(const Polygon& corners, std::size_t polygon, const std::string& frame) {
  Marker marker = markerOf(polygon, frame, "outline", Marker::LINE_STRIP);
  marker.scale.x = kOutlineWidth;
  marker.color = color(0.6, 0.6, 0.6, 1);
  for (const Eigen::Vector2d& corner : corners) {
    marker.points.push_back(pointAt(corner, kOutlineHeight));
  }
  marker.points.push_back(marker.points.front());
  return marker;
}

Marker areaMarker(const std::vector<Triangle>& triangles, std::size_t polygon,
                  const std::string& frame) {
  Marker marker = markerOf(polygon, frame, "area", Marker::TRIANGLE_LIST);
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color = color(0.1, 0.6, 1, kEmptyAlpha);
  for (const Triangle& triangle : triangles) {
    for (const Eigen::Vector2d& corner : triangle) {
      marker.points.push_back(pointAt(corner, kAreaHeight));
    }
  }
  return marker;
}

/// The middle of the polygon or, if that is outside of it, of its largest triangle.
Eigen::Vector2d middleOf(const Polygon& corners, const std::vector<Triangle>& triangles) {
  const Eigen::Vector2d mean = uniformDistribution(corners).mean;
  if (contains(corners, mean) || triangles.empty()) return mean;
  const auto size = [](const Triangle& t) { return areaOf(Polygon(t.begin(), t.end())); };
  const Triangle& largest =
      *std::max_element(triangles.begin(), triangles.end(),
                        [&](const Triangle& a, const Triangle& b) { return size(a) < size(b); });
  return (largest[0] + largest[1] + largest[2]) / 3;
}

Marker nameMarker(const Eigen::Vector2d& position, double area, std::size_t polygon,
                  const std::string& frame) {
  Marker marker = markerOf(polygon, frame, "name", Marker::TEXT_VIEW_FACING);
  marker.pose.position = pointAt(position, kNameHeight);
  marker.scale.z = std::clamp(std::sqrt(area) / 8, 0.2, 0.8);  // m, height of a capital letter
  marker.color = color(1, 1, 1, 1);
  return marker;
}

std::string percentText(double probability) {
  return probability >= 0.005 ? " " + percent(probability, 0) : "";
}

}  // namespace

RoomMarkers::RoomMarkers(const RoomPolygons& rooms, const std::string& frame) {
  const std::vector<RoomPolygon>& polygons = rooms.polygons();
  std::map<std::string, std::size_t> largest;  // polygon of each room
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto& [name, corners] = polygons[i];
    outlines_.push_back(outlineMarker(corners, i, frame));
    areas_.push_back({name, areaMarker(triangulated(corners), i, frame)});
    const auto known = largest.emplace(name, i).first;
    if (areaOf(corners) > areaOf(polygons[known->second].corners)) known->second = i;
  }
  for (const auto& [name, i] : largest) {
    const Polygon& corners = polygons[i].corners;
    names_.push_back(
        {name, nameMarker(middleOf(corners, triangulated(corners)), areaOf(corners), i, frame)});
  }
}

visualization_msgs::MarkerArray RoomMarkers::at(
    const std::function<double(const std::string&)>& probabilityOf) const {
  visualization_msgs::MarkerArray array;
  array.markers = outlines_;
  for (const OfRoom& area : areas_) {
    array.markers.push_back(area.marker);
    array.markers.back().color.a =
        static_cast<float>(kEmptyAlpha + kFullAlpha * probabilityOf(area.room));
  }
  for (const OfRoom& name : names_) {
    array.markers.push_back(name.marker);
    array.markers.back().text = name.room + percentText(probabilityOf(name.room));
  }
  return array;
}

}  // namespace place_recognition
