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

/// From the room to a pose on a map of rooms: has amcl start anew in the room when it is lost,
/// tells the pose to whoever asks, and shows the rooms in rviz. Callbacks come from one thread.
class PlaceToPose {
 public:
  /// Throws Error if the file of rooms or another parameter cannot be used.
  PlaceToPose(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

 private:
  PlaceToPose(ros::NodeHandle node, ros::NodeHandle private_node, Parameters parameters);
  void onBelief(const PlaceRecognitionConstPtr& belief);
  bool onRoomPose(RoomPose::Request& request, RoomPose::Response& response);
  void onTimer();

  /// ROS' time; forgets what was seen and done when it was set back.
  ros::Time followClock();
  /// Says which rooms the model and the file do not share, once for each model.
  void compareRooms(const PlaceRecognition& belief);
  /// If somebody listens, and if they are not shown already.
  void publishMarkers(const ros::Time& now);
  std::string roomsText() const;

  const std::string file_;  // of the rooms
  const RoomPolygons rooms_;
  const std::string map_frame_;
  const RoomMarkers markers_;
  HeldRoom held_;
  Relocalizer relocalizer_;
  std::optional<std::string> model_version_;  // whose rooms were compared last
  ros::Time last_time_;
  std::vector<long> shown_;  // percent of each polygon, as published last; empty: never

  ros::Publisher markers_publisher_;
  ros::Subscriber belief_subscriber_;
  ros::ServiceServer room_pose_server_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
