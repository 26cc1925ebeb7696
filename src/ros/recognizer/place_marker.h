#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <string>

namespace place_recognition {

/// The place as text for rviz, which stands where the camera is and faces the viewer. It vanishes
/// when no other follows for a while.
visualization_msgs::Marker placeMarker(const std::string& place, const std_msgs::Header& header);

}  // namespace place_recognition
