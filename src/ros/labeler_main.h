#pragma once

#include <ros/ros.h>

#include <csignal>
#include <cstdlib>

#include "place_recognition/error.h"

namespace place_recognition {

/// Runs a node that records until it is asked to end, also by kill: then the bag gets its name.
template <typename Labeler>
int runLabeler(int argc, char** argv, const char* name) {
  ros::init(argc, argv, name);
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  const ros::NodeHandle node;
  try {
    const Labeler labeler(node, ros::NodeHandle("~"));
    ros::spin();
  } catch (const Error& e) {
    ROS_FATAL("%s", e.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace place_recognition
