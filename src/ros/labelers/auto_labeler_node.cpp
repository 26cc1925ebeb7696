// auto_labeler: labels images by the robot's pose on a map of rooms. See launch/auto_record.launch.

#include "ros/labelers/auto_labeler.h"

#include "ros/nodes/node_main.h"

int main(int argc, char** argv) {
  return place_recognition::runNode(argc, argv, "auto_labeler", [] {
    place_recognition::AutoLabeler labeler(ros::NodeHandle(), ros::NodeHandle("~"));
    place_recognition::spinUntilEnd(1);
    labeler.finish();
  });
}
