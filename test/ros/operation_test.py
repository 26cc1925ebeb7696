#!/usr/bin/env python3
"""Learning from operation: doubtful frames are kept, and do not replace a better model."""
import os
import subprocess
import sys
import time
import unittest

import cv2
import rosbag
import rospy
from sensor_msgs.msg import CompressedImage

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import NodeCase, paint  # noqa: E402

TOOL = os.environ["PLACE_TOOL"]
TOPIC = "/camera/image_raw/compressed"


class OperationTest(NodeCase):
    def tool(self, *arguments, status=0):
        environment = dict(os.environ, HOME=str(self.home), ROS_HOME=str(self.folder / "ros_home"))
        result = subprocess.run([TOOL, *map(str, arguments)], cwd=self.folder, env=environment,
                                text=True, capture_output=True)
        self.assertEqual(result.returncode, status, result.stderr)
        return result.stdout + result.stderr

    def write_run(self, name, seed=0):
        for room in ("kitchen", "corridor"):
            for view in range(8):
                path = self.folder / name / room / f"{view}.png"
                path.parent.mkdir(parents=True, exist_ok=True)
                cv2.imwrite(str(path), paint(room, view, seed))

    def show(self, rooms):
        """Sends one image after the other, ten per second."""
        publisher = rospy.Publisher(TOPIC, CompressedImage, queue_size=10)
        self.wait_for(lambda: publisher.get_num_connections() > 0, "the node does not listen")
        for i, room in enumerate(rooms):
            message = CompressedImage(format="jpeg",
                                      data=cv2.imencode(".jpg", paint(room, i, 2))[1].tobytes())
            message.header.stamp = rospy.Time.from_sec(time.time())
            publisher.publish(message)
            time.sleep(0.1)
        time.sleep(0.5)
        publisher.unregister()

    def test_doubtful_frames_are_kept_and_wrong_labels_do_no_harm(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.tool("train", "monday", "--model", "home", "--config", "crfh_colour")
        node = self.launch("recognize.launch", "model:=home", "image:=/camera/image_raw",
                           "image_transport:=compressed", "keep_doubtful:=~/doubts",
                           "keep_per_hour:=1000000")
        self.expect(node, "Recognizing with home")
        # Steady answers are not doubtful; each change is.
        self.show(["kitchen"] * 8 + ["corridor", "kitchen"] * 5)
        self.assertEqual(node.interrupt(), 0)
        self.assertIn("images that the model doubts. Label them with: place_tool label", node.output)
        bags = list((self.home / "doubts").glob("doubtful_*.bag"))
        self.assertEqual(len(bags), 1, node.output)
        self.assertFalse(list((self.home / "doubts").glob("*.active")))
        with rosbag.Bag(str(bags[0])) as bag:
            count = bag.get_message_count(TOPIC)
            self.assertGreater(bag.get_message_count("/place_label"), 0)
        self.assertGreaterEqual(count, 2)
        self.assertLess(count, 14)
        self.assertIn(TOPIC, self.tool("info", bags[0]))
        # As if a person had labelled it carelessly.
        complaint = self.tool("train", bags[0], "--label", "kitchen", "--add-to", "home", "--model",
                              "home", "--validate", "tuesday", status=1)
        self.assertIn("The old model is kept", complaint)

    def test_a_folder_that_cannot_be_written_ends_the_node_with_a_message(self):
        (self.folder / "file").write_text("")
        node = self.start_node("place_recognizer", "image:=/camera/image_raw",
                               "_keep_doubtful:=file/doubts")
        self.expect_end(node, 1, "Cannot keep doubtful frames in", "~keep_doubtful")


if __name__ == "__main__":
    unittest.main()
