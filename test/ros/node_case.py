"""Shared code of the tests that start nodes as users do: a separate master, programs whose output
is read, and a camera."""
import atexit
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import cv2
import rosgraph
import rospy
from sensor_msgs.msg import CompressedImage, Image

SOURCE = pathlib.Path(os.environ["PLACE_RECOGNITION_SOURCE_DIR"])
PROGRAMS = pathlib.Path(os.environ["PLACE_RECOGNITION_PROGRAMS"])
PATIENCE = 120  # s, for roslaunch on a busy machine

sys.path.append(str(SOURCE / "test/tool"))
from tool_case import paint  # noqa: E402,F401


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Program:
    """A running program and its output."""

    def __init__(self, command, cwd, environment):
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([str(word) for word in command], cwd=cwd, env=environment,
                                        stdin=subprocess.DEVNULL, stdout=self.log,
                                        stderr=subprocess.STDOUT, start_new_session=True)

    @property
    def output(self):
        return os.pread(self.log.fileno(), 1 << 20, 0).decode()

    def wait(self):
        """Waits for the program to end. Returns its exit code."""
        return self.process.wait(PATIENCE)

    def interrupt(self):
        """Ends the program as Ctrl-C does. Returns its exit code."""
        self.process.send_signal(signal.SIGINT)
        return self.wait()

    def end(self):
        """Ends the program in any case. Asks first, so that roslaunch ends its nodes."""
        self.process.send_signal(signal.SIGINT)
        try:
            self.wait()
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
        self.log.close()


class NodeCase(unittest.TestCase):
    """A test in a scratch folder, which includes the home folder. All tests of a program share one
    master."""
    master = None

    @classmethod
    def setUpClass(cls):
        if NodeCase.master is None:
            port = free_port()
            os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1",
                              ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
            environment = dict(os.environ, ROS_LOG_DIR=tempfile.gettempdir())
            NodeCase.master = Program(["/usr/bin/rosmaster", "--core", "-p", port], None, environment)
            atexit.register(NodeCase.master.end)
            while not rosgraph.is_master_online():
                time.sleep(0.05)
            rospy.init_node("person", disable_signals=True)

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="place recognition ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.home = self.folder / "home"
        self.home.mkdir()

    def start(self, *command, cwd=None):
        environment = dict(os.environ, HOME=str(self.home), ROS_HOME=str(self.folder / "ros_home"))
        program = Program(command, cwd or self.folder, environment)
        self.addCleanup(program.end)
        return program

    def start_node(self, node, *arguments, name=None, cwd=None):
        """Starts a node as rosrun does. Deletes the parameters of earlier tests."""
        name = name or node
        if rospy.has_param(f"/{name}"):
            rospy.delete_param(f"/{name}")
        return self.start(PROGRAMS / node, f"__name:={name}", *arguments, cwd=cwd)

    def launch(self, file, *arguments, cwd=None):
        return self.start("roslaunch", SOURCE / "launch" / file, *arguments, cwd=cwd)

    def wait_for(self, condition, what):
        end = time.time() + PATIENCE
        while not condition():
            self.assertLess(time.time(), end, what() if callable(what) else what)
            time.sleep(0.05)

    def expect(self, program, *texts):
        """Waits until the program has written all of the texts."""
        self.wait_for(lambda: all(text in program.output for text in texts),
                      lambda: f"{texts} in:\n{program.output}")

    def expect_end(self, program, status, *texts):
        """Expects that the program ends by itself, with this exit code and these texts."""
        self.assertEqual(program.wait(), status, program.output)
        for text in texts:
            self.assertIn(text, program.output)


class Camera:
    """Publishes images of a room on `topic`: JPEG if it ends in "/compressed", otherwise Image."""

    def __init__(self, topic="/camera/image_raw", compressed=True, queue_size=100):
        self.compressed = compressed
        self.count = 0
        self.publisher = rospy.Publisher(topic + ("/compressed" if compressed else ""),
                                         CompressedImage if compressed else Image,
                                         queue_size=queue_size)

    def listeners(self):
        return self.publisher.get_num_connections()

    def message(self, stamp=None):
        picture = paint("kitchen", self.count % 4)
        if self.compressed:
            message = CompressedImage(format="jpeg", data=cv2.imencode(".jpg", picture)[1].tobytes())
        else:
            message = Image(height=96, width=128, encoding="bgr8", step=384, data=picture.tobytes())
        message.header.stamp = stamp or rospy.Time.from_sec(time.time())
        self.count += 1
        return message

    def send(self, stamp=None):
        self.publisher.publish(self.message(stamp))

    def close(self):
        self.publisher.unregister()
