// place_labeler: records a run while a person states the rooms. See launch/record.launch.

#include "ros/labelers/place_labeler.h"

#include "ros/nodes/node_main.h"

int main(int argc, char** argv) {
  return place_recognition::runNode(argc, argv, "place_labeler", [] {
    place_recognition::PlaceLabeler labeler(ros::NodeHandle(), ros::NodeHandle("~"));
    place_recognition::spinUntilEnd(1);
    labeler.finish();
  });
}
