// place_to_pose: converts the room to a pose on the map. See launch/relocalize.launch.

#include "ros/localization/place_to_pose.h"

#include "ros/nodes/node_main.h"

int main(int argc, char** argv) {
  return place_recognition::runNode(argc, argv, "place_to_pose", [] {
    const place_recognition::PlaceToPose node(ros::NodeHandle(), ros::NodeHandle("~"));
    place_recognition::spinUntilEnd(1);
  });
}
