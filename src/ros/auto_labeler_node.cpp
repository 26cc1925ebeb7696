// auto_labeler: labels images by the robot's pose on a map of rooms. See launch/auto_record.launch.

#include "ros/auto_labeler.h"

#include "ros/labeler_main.h"

int main(int argc, char** argv) {
  return place_recognition::runLabeler<place_recognition::AutoLabeler>(argc, argv, "auto_labeler");
}
