// `nodelet manager` of the package nodelet, compiled with the options of this build. With a
// sanitizer, a program without it could not load the nodelet or would hide its errors.

#include <nodelet/loader.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "manager");
  const nodelet::Loader loader;
  ros::spin();
}
