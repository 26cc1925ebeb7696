#!/usr/bin/env python3
"""Tests that place_recognizer survives a restart of roscore: it answers frames throughout, does not
hang, and ends when told to."""
import os
import signal
import socket
import subprocess
import sys
import time
import unittest

import rospy
from place_recognition.msg import PlaceRecognition
from sensor_msgs.msg import Image

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/tool")
from tool_case import ToolCase, paint  # noqa: E402

PATIENCE = 30  # s


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class RoscoreRestartTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("monday")
        self.succeed("train", "monday", "--model", "home", "--config", "crfh_colour")
        self.port = free_port()
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{self.port}", ROS_IP="127.0.0.1",
                          ROS_HOME=str(self.folder / "ros_home"))

    def start(self, *command):
        process = subprocess.Popen(command, env=self.environment(), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(self.kill, process)
        return process

    def kill(self, process):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()

    def start_master(self):
        # The processes started by roscore, which outlive it if only roscore is killed.
        master = self.start("/usr/bin/rosmaster", "--core", "-p", str(self.port))
        self.wait_for(self.master_listens)
        return master

    def master_listens(self):
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def wait_for(self, condition):
        end = time.time() + PATIENCE
        while not condition():
            self.assertLess(time.time(), end, "too late")
            time.sleep(0.05)

    def expect_answer(self):
        """Sends images until one is answered."""
        self.sent += 1
        picture = paint("kitchen", 1)
        image = Image(height=96, width=128, encoding="bgr8", step=384, data=picture.tobytes())
        image.header.stamp = rospy.Time(self.sent)

        def answered():
            self.camera.publish(image)
            return any(answer.header.stamp == image.header.stamp for answer in self.answers)

        self.wait_for(answered)

    def test_killed_and_started_again(self):
        master = self.start_master()
        node = self.start(os.environ["PLACE_RECOGNIZER"], "image:=/camera", "_model:=home",
                          "__name:=place_recognizer")
        rospy.init_node("camera", disable_signals=True)
        self.sent, self.answers = 0, []
        self.camera = rospy.Publisher("/camera", Image, queue_size=1)
        rospy.Subscriber("/place_recognizer/recognition", PlaceRecognition, self.answers.append)
        self.expect_answer()
        self.kill(master)
        self.assertFalse(self.master_listens())
        for _ in range(3):
            self.expect_answer()
        self.start_master()
        for _ in range(3):
            self.expect_answer()
        node.send_signal(signal.SIGINT)
        node.wait(PATIENCE)


if __name__ == "__main__":
    unittest.main()
