// Acts on the room: logs where the robot is, and the answers to single frames.
//   rosrun listen listen

#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

namespace {

/// Handles the room over time. The topic is latched, so the current room arrives at once.
void onPlace(const std_msgs::String& place) { ROS_INFO("The robot is in: %s", place.data.c_str()); }

/// Handles the answer to one frame, which includes the probability of every room.
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
