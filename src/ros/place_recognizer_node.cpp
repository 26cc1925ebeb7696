// place_recognizer: names the room that a camera sees. See launch/recognize.launch.

#include <ros/ros.h>

#include "ros/place_recognizer.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "place_recognizer");
  const ros::NodeHandle private_node("~");
  place_recognition::PlaceRecognizer recognizer(ros::NodeHandle(), private_node,
                                                ros::this_node::getName());
  ros::MultiThreadedSpinner(4).spin();  // images, services and loading do not wait for each other
}
