// The program of recognizer.test: its tests stand in recognizer_*_rostest.cpp.

#include "ros/recognizer_fixture.h"
#include "ros/rostest_main.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  return runRostest(argc, argv, "recognizer_rostest", [] {
    saveRooms("two", 2);
    saveRooms("three", 3);
  });
}
