#!/usr/bin/env python3
"""Acts on the room: logs where the robot is, and the answers to single frames."""
import rospy
from place_recognition.msg import PlaceRecognition
from std_msgs.msg import String


def on_place(place):
    """Handles the room over time. The topic is latched, so the current room arrives at once."""
    rospy.loginfo("The robot is in: %s", place.data)


def on_recognition(answer):
    """Handles the answer to one frame, which includes the probability of every room."""
    if answer.known:
        rospy.loginfo_throttle(1, f"This frame shows {answer.place} ({100 * answer.confidence:.0f} %)")


if __name__ == "__main__":
    rospy.init_node("listen")
    rospy.Subscriber("place_recognizer/place", String, on_place)
    rospy.Subscriber("place_recognizer/recognition", PlaceRecognition, on_recognition)
    rospy.spin()
