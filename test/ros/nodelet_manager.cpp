// What the package nodelet runs as `nodelet manager`, in the build of the rest: where that has a
// sanitizer, a program without it could not load the nodelet, or would hide what the nodelet does.

#include <nodelet/loader.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "manager");
  const nodelet::Loader loader;
  ros::spin();
}
