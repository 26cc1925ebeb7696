// trainer: learns rooms from labelled bags. See launch/train.launch.

#include <ros/ros.h>

#include "ros/nodes/node_main.h"
#include "ros/trainer/trainer.h"

int main(int argc, char** argv) {
  return place_recognition::runNode(argc, argv, "trainer", [] {
    place_recognition::Trainer trainer(ros::NodeHandle(), ros::NodeHandle("~"));
    // A training by ~retrain leaves three threads for other callbacks, and the end does not wait
    // for it.
    place_recognition::spinUntilEnd(4, [&trainer] { trainer.finish(); });
  });
}
