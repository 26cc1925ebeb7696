#pragma once

#include <place_recognition/PlaceRecognition.h>
#include <place_recognition/RoomPose.h>
#include <ros/ros.h>

#include <optional>
#include <string>
#include <vector>

#include "labels/room_polygons.h"
#include "ros/localization/held_room.h"
#include "ros/localization/relocalizer.h"
#include "ros/localization/room_markers.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Relates rooms to poses on a map of rooms: restarts amcl in the room when it is lost, returns the
/// pose of a room on request, and shows the rooms in rviz. Callbacks come from one thread.
class PlaceToPose {
 public:
  /// Throws Error if the file of rooms or another parameter is unusable.
  PlaceToPose(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

 private:
  PlaceToPose(ros::NodeHandle node, ros::NodeHandle private_node, Parameters parameters);
  void onBelief(const PlaceRecognitionConstPtr& belief);
  bool onRoomPose(RoomPose::Request& request, RoomPose::Response& response);
  void onTimer();

  /// The ROS time. If it was set back, discards everything seen and done.
  ros::Time followClock();
  /// Reports the rooms that only the model or only the file has, once per model.
  void compareRooms(const PlaceRecognition& belief);
  /// Publishes the markers if somebody listens and they have changed.
  void publishMarkers(const ros::Time& now);
  std::string roomsText() const;

  const std::string file_;  // of the rooms
  const RoomPolygons rooms_;
  const std::string map_frame_;
  const RoomMarkers markers_;
  HeldRoom held_;
  Relocalizer relocalizer_;
  std::optional<std::string> model_version_;  // of the last rooms compared
  ros::Time last_time_;
  std::vector<long> shown_;  // percentage of each polygon, as last published; empty: never

  ros::Publisher markers_publisher_;
  ros::Subscriber belief_subscriber_;
  ros::ServiceServer room_pose_server_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
