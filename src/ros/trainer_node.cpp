// trainer: learns rooms from labelled bags. See launch/train.launch.

#include <ros/ros.h>

#include "ros/trainer.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "trainer");
  const ros::NodeHandle private_node("~");
  place_recognition::Trainer trainer(ros::NodeHandle(), private_node);
  ros::MultiThreadedSpinner(4).spin();  // a training by ~retrain leaves three for the rest
}
