#!/usr/bin/env python3
"""Parameters as users pass them: by rosrun, launch files and rosparam."""
import os
import sys
import unittest

import rospy
from place_recognition.srv import SayPlace

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import PROGRAMS, NodeCase  # noqa: E402


class ParametersTest(NodeCase):
    def keys(self, places):
        """Returns the keys that record.launch offers for the argument `places`."""
        program = self.launch("record.launch", "bag:=run.bag", f"places:={places}")
        self.expect(program, "Rooms: ", "0 no place.")
        program.interrupt()
        return program.output.split("Rooms: ")[1].splitlines()[0].replace("\x1b[0m", "")

    def test_places_are_what_was_written(self):
        self.assertEqual(self.keys("[101, 102]"), "1 101, 2 102, 0 no place.")
        self.assertEqual(self.keys("[kitchen, 007, on]"), "1 kitchen, 2 007, 3 on, 0 no place.")
        self.assertEqual(self.keys("kitchen"), "1 kitchen, 0 no place.")

    def test_names_are_tidied_and_those_that_look_alike_are_told(self):
        node = self.start_node("place_labeler", "_places:=[Office_A, office a, 'Ku\u0308che ']")
        # As written, also in the log, in any locale.
        self.expect(node, "1 Office_A, 2 office a, 3 K\u00fcche", "'Office_A' and 'office a' look alike")
        say = rospy.ServiceProxy("/place_labeler/say", SayPlace)
        say.wait_for_service(60)
        self.assertEqual(say(" Ku\u0308che ").message, "In 'K\u00fcche'.")
        self.assertEqual(say(" ").message, "The place: the label ' ' is not a place name (1 to 128 bytes "
                         "of UTF-8 without control characters); rename the place.")
        node.interrupt()

    def test_typed_lists_are_read_as_they_are_meant(self):
        rospy.set_param("/typed/places", ["kitchen", 101, 1.5])
        node = self.start(PROGRAMS / "place_labeler", "__name:=typed")
        self.expect(node, "1 kitchen, 2 101, 3 1.5, 0 no place")
        node.interrupt()

    def test_a_wrong_type_ends_the_node_with_a_sentence(self):
        for node, argument, message in (
                ("place_labeler", "_places:=true", "~places[0] is the truth value true"),
                ("place_labeler", "_places:=[kitchen", "~places"),
                ("place_labeler", "_buttons:=[one]", "~buttons[0] is 'one'; give a whole number"),
                ("place_labeler", "_no_place_button:=x", "~no_place_button is 'x'"),
                ("auto_labeler", "_rooms:=true", "~rooms is the truth value true"),
                ("place_recognizer", "_lazy:=maybe", "~lazy is 'maybe'; give true or false"),
                ("place_recognizer", "_smoothing:=much", "~smoothing is 'much'; give a number"),
                ("place_recognizer", "_smoothing:=-1", "~smoothing is -1; give a number from 0 to 60"),
                ("place_recognizer", "_smoothing_lag:=99", "~smoothing_lag is 99"),
                ("place_recognizer", "_keep_per_hour:=2.5",
                 "~keep_per_hour is 2.5; give a whole number"),
                ("place_recognizer", "_model:=true", "~model is the truth value true"),
                ("place_recognizer", "_image_transport:=jpeg",
                 "~image_transport is 'jpeg'; the installed transports are raw, compressed"),
                ("place_labeler", "_image_transport:=compresed", "Did you mean compressed?"),
                ("place_labeler", "_image_transport:=7", "~image_transport is '7'"),
                ("trainer", "_bag_roots:=false", "~bag_roots[0] is the truth value false")):
            with self.subTest(argument):
                self.expect_end(self.start_node(node, argument), 1, message)

    def test_numbers_stand_for_flags_and_names(self):
        node = self.start_node("place_recognizer", "_model:=2024", "_lazy:=0", "_use_odometry:=1",
                               "image:=/camera")
        self.expect(node, "2024.places")
        master = rospy.get_master()

        def listens(topic):
            subscribers = dict(master.getSystemState()[2][1])
            return "/place_recognizer" in subscribers.get(topic, [])

        self.wait_for(lambda: listens("/camera") and listens("/odom"), "no subscription")
        self.assertEqual(node.interrupt(), 0)

    def test_misspelt_parameters_are_named(self):
        node = self.start_node("place_recognizer", "_modle:=rooms", "_image_transport:=raw",
                               "lazy:=false", "_diagnostic_period:=1")
        self.expect(node, "~modle of /place_recognizer is not known", "did you mean ~model?",
                    "The argument lazy:=false sets no parameter of /place_recognizer; write _lazy:=false.")
        self.assertNotIn("~image_transport", node.output)
        self.assertNotIn("~diagnostic_period", node.output)
        self.assertEqual(node.interrupt(), 0)
        node = self.start_node("place_recognizer", "_model:=rooms", "--lazy=false", "_lazy=false")
        self.expect(node, "The argument --lazy=false has no effect", "The argument _lazy=false has")
        node.interrupt()
        monitor = self.start(PROGRAMS / "place_monitor.py", "_recognizer:=/front", "--idle-exit", "0.1")
        self.expect_end(monitor, 0, "The parameter ~recognizer has no effect here")
        (self.folder / "rooms.yaml").write_text("places: [{name: a, position: [[0, 0], [1, 0], [1, 1]]}]")
        self.expect_end(self.start_node("auto_labeler", "_rooms:=rooms.yaml", "_pose_timeout:=1e30"), 1,
                        "~pose_timeout is 1e+30; give a number from 0 to 3600")
        self.expect_end(self.start_node("place_recognizer", "_model:=rooms", "image_timeout:=3"),
                        1, "The argument image_timeout:=3", "write _image_timeout:=3")
        node = self.start_node("trainer", "_bag_root:=/data")
        self.expect(node, "did you mean ~bag_roots?")
        node.interrupt()

    def test_a_nodelet_names_arguments_that_set_nothing(self):
        manager = self.start(os.environ["PLACE_RECOGNITION_NODELET_MANAGER"], "__name:=manager")
        self.start("rosrun", "nodelet", "nodelet", "load", "place_recognition/PlaceRecognizer", "/manager",
                   "__name:=eyes", "__ns:=/robot", "_model:=rooms", "lazy:=false", "image:=/camera")
        self.expect(manager, "The argument lazy:=false sets no parameter of /robot/eyes; write _lazy:=false.")
        self.assertNotIn("argument image", manager.output)


if __name__ == "__main__":
    unittest.main()
