#!/usr/bin/env python3
"""place_to_pose as on a robot: with a stand-in for amcl, and with a recognizer and a camera."""
import math
import os
import sys
import time
import unittest

import rospy
from rosgraph_msgs.msg import Clock
from visualization_msgs.msg import Marker, MarkerArray

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import Camera  # noqa: E402
from field_test import FieldCase  # noqa: E402
from relocalization_case import ROOMS, Amcl, RelocalizationCase, pose  # noqa: E402


class AmclTest(RelocalizationCase):
    def test_amcl_without_a_pose_is_told_the_room_once(self):
        amcl, believer = self.amcl(), self.believer()
        self.place_to_pose("_publish:=true", "_interval:=0")
        believer.room = "kitchen"
        self.wait_for(lambda: amcl.heard, "amcl hears nothing")
        self.assert_in_kitchen(amcl.heard[0])
        for _ in range(6):  # the room's covariance at first, and less with each scan
            rospy.sleep(0.2)
            amcl.scan()
        rospy.sleep(0.5)
        self.assertEqual(len(amcl.heard), 1)

    def test_amcl_that_knows_where_it_is_is_left_alone(self):
        amcl, believer = self.amcl(), self.believer()
        amcl.say(pose(100, 0, (0.9, 0.9, 0.1)))
        self.place_to_pose("_publish:=true", "_interval:=0")
        believer.room = "kitchen"
        rospy.sleep(2.5)
        self.assertEqual(amcl.heard, [])
        amcl.say(pose(100, 0, (0.1, 1.1, 0.1)))
        self.wait_for(lambda: amcl.heard, "amcl is lost, but hears nothing")
        self.assert_in_kitchen(amcl.heard[0])

    def test_poses_that_are_not_numbers_are_those_of_a_lost_robot(self):
        nan = math.nan
        amcl, believer = self.amcl(), self.believer()
        believer.room = "kitchen"
        for lost in (pose(3, 1.5, (nan, nan, nan)), pose(nan, nan, (0.1, 0.1, 0.1)),
                     pose(3, math.inf, (0.1, 0.1, 0.1))):
            amcl.say(lost)
            node = self.place_to_pose("_publish:=true")
            self.expect(node, "amcl is lost (its pose is not finite); restarting it in 'kitchen'")
            self.wait_for(lambda: amcl.heard, "amcl hears nothing")
            node.interrupt()
            amcl.heard.clear()

    def test_a_pose_is_published_once_per_interval(self):
        amcl, believer = self.amcl(deaf=True), self.believer()
        amcl.say(pose(100, 0, (50, 50, 3)))
        node = self.place_to_pose("_publish:=true", "_interval:=2")
        believer.room = "lab"
        self.wait_for(lambda: amcl.heard, "amcl hears nothing")
        self.assertAlmostEqual(amcl.heard[0].pose.pose.position.x, 17)  # mean of two polygons
        self.assertAlmostEqual(amcl.heard[0].pose.covariance[0], 16 / 12 + 25)
        self.wait_for(lambda: len(amcl.heard) == 3, "amcl hears no more")
        for earlier, later in zip(amcl.heard, amcl.heard[1:]):
            self.assertGreaterEqual((later.header.stamp - earlier.header.stamp).to_sec(), 2)
        self.assertIn("amcl is lost (its position deviates by 7.07 m); restarting it in 'lab'", node.output)

    def test_a_room_that_is_not_sure_tells_amcl_nothing(self):
        amcl, believer = self.amcl(), self.believer()
        self.place_to_pose("_publish:=true", hold=1.5)
        believer.probability = 0.8
        believer.room = "kitchen"
        rospy.sleep(2)
        believer.probability, believer.known = 0.97, False
        rospy.sleep(2)
        believer.known = True
        for room in ["lab", "kitchen"] * 5:
            believer.room = room
            rospy.sleep(0.25)
        self.assertEqual(amcl.heard, [])

    def test_nothing_is_published_unless_it_is_asked_for(self):
        amcl, believer = self.amcl(), self.believer()
        self.place_to_pose()
        believer.room = "kitchen"
        self.wait_for(lambda: self.room_pose().success, "the room is never sure")
        self.assert_in_kitchen(self.room_pose().pose)
        rospy.sleep(1.5)
        self.assertEqual(amcl.heard, [])
        self.assertEqual(amcl.subscriber.get_num_connections(), 0)

    def test_another_map_is_told(self):
        amcl, believer = self.amcl("level2"), self.believer()
        amcl.say(pose(100, 0, (50, 50, 3), "level2"))
        node = self.place_to_pose("_publish:=true")
        believer.room = "kitchen"
        self.expect(node, "/amcl_pose is in the frame 'level2', but the rooms are in 'map'",
                    "Set ~map_frame to 'level2'")
        amcl.say(pose(101, 0, (50, 50, 3), "level2"))
        rospy.sleep(1.5)
        self.assertEqual(amcl.heard, [])
        self.assertEqual(node.output.count("Set ~map_frame"), 1)
        node.interrupt()
        self.place_to_pose("_publish:=true", "_map_frame:=/level2")
        self.wait_for(lambda: amcl.heard, "amcl hears nothing")
        self.assertEqual(amcl.heard[0].header.frame_id, "level2")

    def test_nobody_listens(self):
        believer = self.believer()
        node = self.place_to_pose("_publish:=true")
        believer.room = "kitchen"
        self.expect(node, "No pose has arrived on /amcl_pose, but nobody subscribes to /initialpose")
        rospy.sleep(0.5)
        self.assertEqual(node.output.count("nobody subscribes"), 1)
        amcl = self.amcl()
        self.wait_for(lambda: amcl.heard, "amcl hears nothing")

    def test_amcl_does_not_answer(self):
        amcl, believer = self.amcl(deaf=True), self.believer()
        node = self.place_to_pose("_publish:=true")
        believer.room = "kitchen"
        self.expect(node, "No pose has arrived on /amcl_pose for 5 s after one was published on /initialpose")
        self.assertEqual(len(amcl.heard), 1)
        rospy.sleep(1)
        self.assertEqual(node.output.count("No pose has arrived"), 2, node.output)  # first: restarting it


class ServiceTest(RelocalizationCase):
    def test_the_pose_of_a_room_is_told_to_whoever_asks(self):
        self.place_to_pose()
        answer = self.room_pose(" kitchen ")
        self.assertTrue(answer.success)
        self.assertEqual(answer.place, "kitchen")
        self.assert_in_kitchen(answer.pose)
        answer = self.room_pose("Kitchen")
        self.assertFalse(answer.success)
        self.assertEqual(answer.message, f"{self.folder}/rooms.yaml has no room 'Kitchen'; its rooms are "
                         "'kitchen', 'lab', 'cupboard'.")

    def test_it_says_why_no_room_is_sure(self):
        believer = self.believer()
        self.place_to_pose("_belief_timeout:=0.5")
        self.assertEqual(self.room_pose().message,
                         "The room is not certain: no answer of place_recognizer has arrived.")
        believer.room = "kitchen"
        self.wait_for(lambda: self.room_pose().success, "the room is never sure")
        believer.probability = 0.5
        self.wait_for(lambda: "a probability of 0.50, less than ~min_probability" in
                      self.room_pose().message, lambda: self.room_pose().message)
        believer.known = False
        self.wait_for(lambda: self.room_pose().message == "The room is not certain: the answer is 'unknown'.",
                      lambda: self.room_pose().message)
        believer.room = None  # as when the camera fails
        self.wait_for(lambda: "the last answer of place_recognizer arrived" in self.room_pose().message,
                      lambda: self.room_pose().message)

    def test_rooms_that_the_file_lacks_are_named_once(self):
        amcl, believer = self.amcl(), self.believer()
        believer.rooms = ["cellar", "kitchen", "attic"]
        node = self.place_to_pose("_publish:=true")
        believer.room = "cellar"
        self.expect(node, f"The model 'home' knows 'cellar', 'attic', for which {self.folder}/rooms.yaml "
                    "has no polygon", "Its rooms are 'kitchen', 'lab', 'cupboard'.",
                    "does not know 'lab', 'cupboard'")
        rospy.sleep(1.5)
        self.assertEqual(node.output.count("has no polygon"), 1)
        self.assertIn("has no room 'cellar'", self.room_pose().message)
        self.assertEqual(amcl.heard, [])
        believer.room = "kitchen"
        self.wait_for(lambda: amcl.heard, "amcl hears nothing")

    def test_a_file_that_cannot_be_used_is_told_in_a_sentence(self):
        for text, reason in (
                ("places: [{name: a, position: [[0, 0], [1", "is not valid YAML"),
                ("places: [{name: a, position: [[0, 0], [4, 0], [0, 3], [4, 3]]}]",
                 "places[0]: the wall from [4, 0] to [0, 3] crosses that from [4, 3] to [0, 0]")):
            (self.folder / "rooms.yaml").write_text(text)
            self.expect_end(self.start_node("place_to_pose", "_rooms:=rooms.yaml"), 1, reason)
        self.expect_end(self.start_node("place_to_pose"), 1, "The parameter ~rooms is not set")
        self.expect_end(self.start_node("place_to_pose", "_rooms:=no.yaml"), 1, "Cannot read")

    def test_parameters_are_read_as_those_of_all_nodes(self):
        node = self.place_to_pose("_pubilsh:=true", "_lost_deviation:=2")
        self.expect(node, "~pubilsh of /place_to_pose is not known", "did you mean ~publish?")
        for argument, message in (("_publish:=maybe", "~publish is 'maybe'; give true or false"),
                                  ("_min_probability:=90", "~min_probability is 90; give a number from 0 to 1"),
                                  ("_hold:=-1", "~hold is -1")):
            self.expect_end(self.start_node("place_to_pose", "_rooms:=rooms.yaml", argument), 1, message)


class ClockTest(RelocalizationCase):
    def test_time_that_is_set_back_restarts_it(self):
        rospy.set_param("/use_sim_time", True)
        self.addCleanup(rospy.set_param, "/use_sim_time", False)
        clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self.addCleanup(clock.unregister)
        amcl, believer = self.amcl(deaf=True), self.believer()
        amcl.say(pose(100, 0, (50, 50, 3)))
        node = self.place_to_pose("_publish:=true", "_interval:=1000")
        believer.room = "kitchen"
        time.sleep(0.5)
        self.assertEqual(self.room_pose().message,
                         "The room is not certain: no answer of place_recognizer has arrived.")

        def run(seconds):
            """Publishes a clock that starts at 100 s."""
            for step in range(int(20 * seconds)):
                clock.publish(Clock(rospy.Time(100) + rospy.Duration(0.05 * step)))
                time.sleep(0.05)

        self.wait_for(clock.get_num_connections, "nobody wants the clock")
        run(2)
        self.assertEqual(len(amcl.heard), 1, node.output)
        run(0.3)
        self.assertIn("less than ~hold", self.room_pose().message)
        self.assertEqual(len(amcl.heard), 1)
        run(2)
        self.wait_for(lambda: len(amcl.heard) == 2, "the interval goes on from a time that is no more")


class MarkersTest(RelocalizationCase):
    def markers(self):
        """Returns the markers that rviz would show, by namespace and number."""
        held = {}

        def take(array):
            for marker in array.markers:
                if marker.action == Marker.DELETEALL:
                    held.clear()
                else:
                    held[marker.ns, marker.id] = marker

        subscriber = rospy.Subscriber("/place_to_pose/room_markers", MarkerArray, take)
        self.addCleanup(subscriber.unregister)
        return held

    def test_rooms_are_filled_by_the_belief_also_for_late_subscribers(self):
        believer = self.believer()
        self.place_to_pose("_belief_timeout:=1")
        for held in (self.markers(), self.markers()):
            believer.room = "lab"
            self.wait_for(lambda: held and held["name", 1].text == "lab 97 %", lambda: f"{held}")
            self.assertEqual(len(held), 4 + 4 + 3)
            self.assertEqual(held["area", 1].color.a, held["area", 2].color.a)
            self.assertGreater(held["area", 1].color.a, 10 * held["area", 0].color.a)
            believer.room = "kitchen"
            self.wait_for(lambda: held["name", 0].text == "kitchen 97 %", lambda: f"{held}")
            self.assertGreater(held["area", 0].color.a, 10 * held["area", 1].color.a)
            believer.room = None
            self.wait_for(lambda: held["name", 0].text == "kitchen", "the belief does not fade")
        late = self.markers()
        self.wait_for(lambda: len(late) == 11, "nothing is latched")


class RobotTest(FieldCase):
    """A trained recognizer, a camera, and a robot that does not know where it is."""

    def test_a_lost_robot_is_told_its_room_by_its_camera(self):
        self.train(self.write_run("run.bag"))
        (self.folder / "rooms.yaml").write_text(ROOMS)
        amcl = Amcl()
        self.addCleanup(amcl.close)
        amcl.say(pose(100, 0, (400, 400, 3)))
        camera = Camera(compressed=False)
        self.addCleanup(camera.close)
        recognizer = self.launch("recognize.launch", "model:=home")
        self.expect(recognizer, "Recognizing with home")  # two starts at once interfere
        node = self.launch("relocalize.launch", f"rooms:={self.folder}/rooms.yaml", "publish:=true",
                           "min_probability:=0.9")
        self.wait_for(camera.listeners, "nobody listens to the camera")
        self.wait_for(lambda: camera.send() or rospy.sleep(0.05) or amcl.heard, lambda: node.output)
        self.assertAlmostEqual(amcl.heard[0].pose.pose.position.x, 3)
        self.assertAlmostEqual(amcl.heard[0].pose.covariance[0], 3)
        self.expect(node, "amcl is lost (its position deviates by 20.00 m); restarting it in 'kitchen'")


if __name__ == "__main__":
    unittest.main()
