#include "ros/recognizer/place_marker.h"

#include <ros/duration.h>

namespace place_recognition {

visualization_msgs::Marker placeMarker(const std::string& place, const std_msgs::Header& header) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = "place";
  marker.type = visualization_msgs::Marker::TEXT_VIEW_FACING;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.z = 0.4;  // m, height of a capital letter
  marker.color.r = marker.color.g = marker.color.b = marker.color.a = 1;
  marker.lifetime = ros::Duration(5);
  marker.text = place;
  return marker;
}

}  // namespace place_recognition
