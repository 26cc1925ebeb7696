#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <string>

namespace place_recognition {

/// The main program of a rostest: a node with that name, whose callbacks run beside its tests.
/// `prepare` creates what the tests need.
template <typename Prepare>
int runRostest(int argc, char** argv, const std::string& name, const Prepare& prepare) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, name);
  const ros::NodeHandle node;  // keeps the node alive
  ros::AsyncSpinner spinner(2);
  spinner.start();
  prepare();
  return RUN_ALL_TESTS();
}

}  // namespace place_recognition
