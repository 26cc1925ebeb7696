// trainer: learns rooms from labelled bags. See launch/train.launch.

#include <ros/ros.h>

#include "ros/nodes/node_main.h"
#include "ros/trainer/trainer.h"

int main(int argc, char** argv) {
  return place_recognition::runNode(argc, argv, "trainer", [] {
    const place_recognition::Trainer trainer(ros::NodeHandle(), ros::NodeHandle("~"));
    place_recognition::spinUntilEnd(4);  // a training by ~retrain leaves three for the rest
  });
}
