// Acts on the room: says where the robot has come to, and how sure the single frames are of it.
//   rosrun listen listen

#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

namespace {

/// The room over time; it is latched, so the first one comes at once.
void onPlace(const std_msgs::String& place) { ROS_INFO("The robot is in: %s", place.data.c_str()); }

/// The answer to one frame, with the probability of every room.
void onRecognition(const place_recognition::PlaceRecognition& answer) {
  if (!answer.known) return;
  ROS_INFO_THROTTLE(1, "This frame shows %s (%.0f %%)", answer.place.c_str(),
                    100 * answer.confidence);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "listen");
  ros::NodeHandle node;
  const ros::Subscriber place = node.subscribe("place_recognizer/place", 1, onPlace);
  const ros::Subscriber recognition =
      node.subscribe("place_recognizer/recognition", 1, onRecognition);
  ros::spin();
}
