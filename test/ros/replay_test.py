#!/usr/bin/env python3
"""Tests replay.launch as users call it, with the recognizer as the only subscriber."""
import os
import sys
import unittest

import cv2
import rosbag
import rospy
from place_recognition.msg import PlaceRecognition
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Header, String

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import PROGRAMS, NodeCase, paint  # noqa: E402

FRAMES = 16


class ReplayTest(NodeCase):
    def setUp(self):
        super().setUp()
        self.trip = self.folder / "Monday's trip"
        self.trip.mkdir()

    def write_run(self, path, topic="/camera/image_raw", labels="/place_label", frames=range(FRAMES)):
        with rosbag.Bag(str(path), "w") as bag:
            for i in frames:
                if i % 8 == 0:
                    bag.write(labels, String(("kitchen", "office")[i // 8]), rospy.Time(1000 + i))
                image = CompressedImage(format="jpeg", data=cv2.imencode(
                    ".jpg", paint(("kitchen", "office")[i // 8], i))[1].tobytes())
                image.header.stamp = rospy.Time(1000 + i)
                bag.write(topic + "/compressed", image, rospy.Time(1000 + i))
        return path

    def replay(self, bag, *arguments):
        """Returns the stamps of the frames that were answered."""
        heard = []
        subscriber = rospy.Subscriber("/place_recognizer/recognition", PlaceRecognition, heard.append)
        self.addCleanup(subscriber.unregister)
        program = self.launch("replay.launch", f"bag:={bag}", "model:=home", "rate:=10", *arguments,
                              cwd=self.trip)
        program.wait()
        self.assertIn("Playing /", program.output)
        self.assertNotIn("exit code", program.output)
        self.assertFalse(rospy.has_param("/use_sim_time"))
        return sorted(message.header.stamp.secs for message in heard)

    def test_every_frame_is_answered_though_nobody_listens_to_the_labels(self):
        self.write_run(self.trip / "the run.bag")
        self.write_run(self.home / "run.bag")
        bare = self.write_run(self.trip / "bare.bag", "camera/image_raw", "place_label")
        for part, frames in enumerate((range(9), range(9, FRAMES))):
            self.write_run(self.trip / f"part {part}.bag", frames=frames)
        program = self.start(os.environ["PLACE_TOOL"], "train", bare, "--model", "home", "--config",
                             "crfh_colour")
        self.assertEqual(program.wait(), 0, program.output)
        for given, arguments in ((self.trip / "the run.bag", []), ("the run.bag", ["loop:=no"]),
                                 ("~/run.bag", ["image:=camera/image_raw"]), ("$HOME/run.bag", []),
                                 ("bare.bag", []), ("[part 0.bag, part 1.bag]", [])):
            with self.subTest(str(given)):
                self.assertEqual(self.replay(given, *arguments),
                                 list(range(1000, 1000 + FRAMES)))

    def test_the_monitor_compares_the_room_over_time_with_the_labels(self):
        run = self.write_run(self.trip / "run.bag")
        program = self.start(os.environ["PLACE_TOOL"], "train", run, "--model", "home", "--config",
                             "crfh_colour")
        self.assertEqual(program.wait(), 0, program.output)
        monitor = self.start(PROGRAMS / "place_monitor.py")
        self.replay(run)
        self.assertEqual(monitor.interrupt(), 0)
        lines = monitor.output.splitlines()
        self.assertRegex(lines[0], r"^ +0\.00 s   kitchen +\d+ %")
        self.assertRegex(lines[-2], r"^ +\d+\.00 s   office +\d+ %   right   truth: office$")
        self.assertRegex(lines[-1], r"^\d+ frames answered, .* of the labelled frames "
                                   r"\d+\.\d % are right frame by frame, \d+\.\d % over time$")

    def test_what_cannot_be_played_is_told(self):
        run = self.write_run(self.trip / "the run.bag")
        (self.trip / "notes.bag").write_text("notes")
        (self.trip / "noise.bag").write_bytes(bytes(range(128, 256)))
        settings = {"BAG": run, "RATE": "1", "LOOP": "false", "IMAGE": "/camera/image_raw",
                    "TRANSPORT": "compressed", "ODOMETRY": "none"}
        self.write_run(self.trip / "killed.bag.active")
        raw = self.trip / "raw.bag"
        with rosbag.Bag(str(raw), "w") as bag:
            bag.write("/camera/image_raw", Image(header=Header(stamp=rospy.Time(1000))), rospy.Time(1000))
        for name, value, words in (
                ("BAG", self.trip / "the lost run.bag", "There is no file"),
                ("BAG", self.trip, "is a folder; give a bag in it as bag:=PATH"),
                ("BAG", self.trip / "the run", "There is no file"),
                ("BAG", self.trip / "the run", f"; give {self.trip}/the run.bag, which"),
                ("BAG", self.trip / "killed.bag", "killed.bag.active lies beside it: it is being "
                 "recorded, or was left behind by a killed recorder; in the latter case run: rosbag "
                 f"reindex {self.trip}/killed.bag.active, and rename it to {self.trip}/killed.bag"),
                ("BAG", self.trip / "killed", "killed.bag.active lies beside it"),
                ("BAG", self.trip / "notes.bag", "copy or record it again"),
                ("BAG", self.trip / "noise.bag", "noise.bag: "),
                ("BAG", f"[{run}, lost.bag]", "lost.bag; give the path of a bag as bag:=PATH"),
                ("BAG", "[", "give a path, or a list as in bag:='[run_0.bag, run_1.bag]'"),
                ("RATE", "fast", "The argument rate is 'fast'; give a number above 0"),
                ("RATE", "0", "give a number above 0"), ("RATE", "nan", "give a number above 0"),
                ("BAG", raw, "raw.bag has raw images on /camera/image_raw; add image_transport:=raw."),
                ("TRANSPORT", "raw", "has compressed images on /camera/image_raw; add "
                                     "image_transport:=compressed."),
                ("LOOP", "maybe", "The argument loop is 'maybe'; give true or false"),
                ("IMAGE", "/front", "has no images on /front; image topics: "
                                    "/camera/image_raw/compressed"),
                ("IMAGE", "/camera/image_raw/compressed",
                 "give the topic without /compressed: image:=/camera/image_raw"),
                ("TRANSPORT", "theora",
                 "The argument image_transport is 'theora'; give raw or compressed."),
                ("ODOMETRY", "/odom", "has no odometry (nav_msgs/Odometry) on /odom; odometry "
                                      "topics: none. Give one of them, or leave out odometry.")):
            with self.subTest(f"{name} {value}"):
                program = self.start("env", *(f"{key}={given}" for key, given in
                                              {**settings, name: value}.items()),
                                     PROGRAMS / "play_bag.py")
                self.expect_end(program, 1, words)

    def test_a_relative_path_starts_where_roslaunch_was_called(self):
        missing = self.launch("replay.launch", "bag:=the lost run.bag", cwd=self.trip)
        self.expect(missing, f"There is no file {self.trip / 'the lost run.bag'}; give")


if __name__ == "__main__":
    unittest.main()
