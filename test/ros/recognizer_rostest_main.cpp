// The program of recognizer.test: its tests stand in recognizer_*_rostest.cpp.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "ros/recognizer_fixture.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "recognizer_rostest");
  ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  place_recognition::saveRooms("two", 2);
  place_recognition::saveRooms("three", 3);
  return RUN_ALL_TESTS();
}
