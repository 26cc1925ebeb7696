#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <string>

namespace place_recognition {

/// The place as text for rviz, shown at the camera and facing the viewer. It disappears if no other
/// marker follows for a while.
visualization_msgs::Marker placeMarker(const std::string& place, const std_msgs::Header& header);

}  // namespace place_recognition
