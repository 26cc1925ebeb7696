// place_recognizer: names the room that a camera sees. See launch/recognize.launch.

#include <ros/ros.h>

#include "ros/nodes/node_main.h"
#include "ros/recognizer/place_recognizer.h"

int main(int argc, char** argv) {
  return place_recognition::runNode(argc, argv, "place_recognizer", [] {
    const place_recognition::PlaceRecognizer recognizer(ros::NodeHandle(), ros::NodeHandle("~"),
                                                        ros::this_node::getName());
    place_recognition::spinUntilEnd(4);  // images, services and loading do not wait for each other
  });
}
