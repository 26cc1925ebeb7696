// The main program of recognizer.test, whose tests are in recognizer_*_rostest.cpp.

#include "recognition/network_options.h"
#include "ros/recognizer_fixture.h"
#include "ros/rostest_main.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  return runRostest(argc, argv, "recognizer_rostest", [] {
    saveRooms("two", 2);
    saveRooms("three", 3);
    saveRooms("cues", 3, twoCueOptions());
    saveRooms("network", 3, networkOptions());
  });
}
