"""place_to_pose beside stand-ins for amcl and place_recognizer, for tests."""
import math
import os
import sys
import threading
import time

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from place_recognition.msg import PlaceRecognition, PlaceScore
from place_recognition.srv import RoomPose
from std_msgs.msg import Header

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import NodeCase  # noqa: E402

ROOMS = """places:
  - name: kitchen
    position: [[0, 0], [6, 0], [6, 3], [0, 3]]
  - name: lab
    position: [[10, 0], [14, 0], [14, 4], [10, 4]]
  - name: lab
    position: [[20, 0], [24, 0], [24, 4], [20, 4]]
  - name: cupboard
    position: [[6, 0], [7, 0], [7, 1], [6, 1]]
"""


def pose(x, y, covariance, frame="map"):
    """Returns a pose; `covariance`: the variances of x, y and the heading."""
    message = PoseWithCovarianceStamped(header=Header(frame_id=frame, stamp=rospy.Time.now()))
    message.pose.pose.position.x, message.pose.pose.position.y = x, y
    message.pose.pose.orientation.w = 1
    values = [0.0] * 36
    values[0], values[7], values[35] = covariance
    message.pose.covariance = values
    return message


class Amcl:
    """A stand-in for amcl: accepts a pose on `initialpose` and publishes its own, latched, on
    `amcl_pose`. Each scan makes it more certain. Like amcl, it ignores poses in other frames."""

    def __init__(self, frame="map", deaf=False):
        self.frame, self.deaf = frame, deaf
        self.heard = []
        self.estimate = None
        self.lock = threading.Lock()
        self.publisher = rospy.Publisher("/amcl_pose", PoseWithCovarianceStamped, queue_size=2, latch=True)
        self.subscriber = rospy.Subscriber("/initialpose", PoseWithCovarianceStamped, self.take)

    def take(self, message):
        with self.lock:
            self.heard.append(message)
        if not self.deaf and message.header.frame_id == self.frame:
            self.say(message)

    def say(self, message):
        self.estimate = message
        self.publisher.publish(message)

    def scan(self):
        """Simulates another scan, which halves all variances."""
        self.estimate.pose.covariance = [value / 2 for value in self.estimate.pose.covariance]
        self.say(self.estimate)

    def close(self):
        self.subscriber.unregister()
        self.publisher.unregister()


class Believer:
    """Publishes answers over time as place_recognizer does, at 20 Hz."""

    def __init__(self, topic="/place_recognizer/belief"):
        self.publisher = rospy.Publisher(topic, PlaceRecognition, queue_size=10)
        self.rooms = ["kitchen", "lab", "cupboard"]
        self.room, self.probability, self.known = None, 0.97, True
        self.going = True
        self.thread = threading.Thread(target=self.publish)
        self.thread.start()

    def publish(self):
        while self.going:
            if self.room:
                rest = (1 - self.probability) / (len(self.rooms) - 1)
                self.publisher.publish(PlaceRecognition(
                    model_name="home", model_version="1", place=self.room, known=self.known,
                    confidence=self.probability, evidence=1, places=[
                        PlaceScore(name=room, probability=self.probability if room == self.room else rest)
                        for room in self.rooms]))
            time.sleep(0.05)

    def close(self):
        self.going = False
        self.thread.join()
        self.publisher.unregister()


class RelocalizationCase(NodeCase):
    def setUp(self):
        super().setUp()
        (self.folder / "rooms.yaml").write_text(ROOMS)

    def amcl(self, *arguments, **options):
        amcl = Amcl(*arguments, **options)
        self.addCleanup(amcl.close)
        return amcl

    def believer(self):
        believer = Believer()
        self.addCleanup(believer.close)
        return believer

    def place_to_pose(self, *arguments, hold=0.5):
        node = self.start_node("place_to_pose", "_rooms:=rooms.yaml", f"_hold:={hold}",
                               "_min_probability:=0.9", *arguments)
        self.expect(node, "the rooms 'kitchen', 'lab', 'cupboard'.")
        return node

    def room_pose(self, room=""):
        rospy.wait_for_service("/place_to_pose/room_pose", 60)
        return rospy.ServiceProxy("/place_to_pose/room_pose", RoomPose)(room)

    def assert_in_kitchen(self, message):
        position, covariance = message.pose.pose.position, message.pose.covariance
        self.assertEqual(message.header.frame_id, "map")
        self.assertAlmostEqual(position.x, 3)
        self.assertAlmostEqual(position.y, 1.5)
        expected = [0.0] * 36
        expected[0], expected[7], expected[35] = 36 / 12, 9 / 12, (2 * math.pi) ** 2 / 12
        for value, wanted in zip(covariance, expected):
            self.assertAlmostEqual(value, wanted)
