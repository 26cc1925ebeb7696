#!/usr/bin/env python3
"""Acts on the room: says where the robot has come to, and how sure the single frames are of it."""
import rospy
from place_recognition.msg import PlaceRecognition
from std_msgs.msg import String


def on_place(place):
    """The room over time; it is latched, so the first one comes at once."""
    rospy.loginfo("The robot is in: %s", place.data)


def on_recognition(answer):
    """The answer to one frame, with the probability of every room."""
    if answer.known:
        rospy.loginfo_throttle(1, f"This frame shows {answer.place} ({100 * answer.confidence:.0f} %)")


if __name__ == "__main__":
    rospy.init_node("listen")
    rospy.Subscriber("place_recognizer/place", String, on_place)
    rospy.Subscriber("place_recognizer/recognition", PlaceRecognition, on_recognition)
    rospy.spin()
