#!/usr/bin/env python3
"""Tests examples/ as users see them: built against an installed tree, and run.

examples_test.py CMAKE BUILD_FOLDER [ros]
"""
import os
import pathlib
import re
import socket
import subprocess
import sys
import time
import unittest

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/tool")
from tool_case import SOURCE, ToolCase, paint  # noqa: E402

CMAKE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
ROS = sys.argv[3:] == ["ros"]
PATIENCE = 60  # s


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} failed:\n{done.stdout}")
    return done.stdout


class ReadmeTest(unittest.TestCase):
    def test_shows_lines_of_the_examples(self):
        readme = (SOURCE / "README.md").read_text()
        section = readme.split("## In your own program")[1].split("## More")[0]
        examples = "".join(path.read_text() for path in (SOURCE / "examples").rglob("*.*"))
        shown = [line for block in re.findall(r"```\w+\n(.*?)```", section, re.DOTALL)
                 for line in block.splitlines()]
        self.assertGreater(len(shown), 5)
        for line in shown:
            self.assertIn(line + "\n", examples)


class InstalledCase(ToolCase):
    def setUp(self):
        super().setUp()
        self.prefix = self.folder / "prefix"
        run(CMAKE, "--install", BUILD, "--prefix", self.prefix, env=dict(os.environ, DESTDIR=""))

    def build(self, source):
        folder = self.folder / source.name
        run(CMAKE, "-S", source, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_PREFIX_PATH={self.prefix};{os.environ.get('CMAKE_PREFIX_PATH', '').replace(':', ';')}",
            "-DPYTHON_EXECUTABLE=/usr/bin/python3")
        run(CMAKE, "--build", folder, "--parallel")
        return folder


class PlainTest(InstalledCase):
    def test_every_header_compiles_by_itself(self):
        headers = len(list((SOURCE / "include/place_recognition").iterdir()))
        built = self.build(SOURCE / "test/examples/headers")
        self.assertEqual(len(list(built.rglob("*.o"))), headers)

    def test_train_tune_and_recognize(self):
        self.write_run("rooms", views=6)
        picture = self.write_image("now.png", paint("office", 7))
        programs = self.build(SOURCE / "examples")
        report = run(programs / "train", self.folder / "rooms", self.folder / "home.places")
        self.assertIn("3 rooms from 18 images", report)
        answer = run(programs / "recognize", self.folder / "home.places", picture).split()
        self.assertEqual(answer[0], "office")
        for library in ("libroscpp", "libnodeletlib", "libtf2"):
            self.assertNotIn(library, run("ldd", programs / "train"))


@unittest.skipUnless(ROS, "built without ROS")
class CatkinTest(InstalledCase):
    def test_the_library_links_with_and_without_ros(self):
        self.write_run("rooms", views=6)
        programs = self.build(SOURCE / "test/examples/catkin")
        for program in programs.glob("devel/lib/consumer/train_by_*"):
            self.assertIn("3 rooms", run(program, self.folder / "rooms", self.folder / "a.places"))
        linked = run("ldd", programs / "devel/lib/consumer/train_by_target")
        for library in ("libroscpp", "libros", "libnodeletlib", "libtf2"):
            self.assertNotIn(library, linked)

    def test_the_nodes_hear_the_room(self):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1",
                          ROS_HOME=str(self.folder / "ros_home"),
                          ROSCONSOLE_STDOUT_LINE_BUFFERED="1", PYTHONUNBUFFERED="1")
        listener = self.build(SOURCE / "examples/listen")
        self.start("rosmaster", "--core", "-p", str(port))
        heard = [self.start(listener / "devel/lib/listen/listen", stdout="cpp.log"),
                 self.start("/usr/bin/python3", SOURCE / "examples/listen/listen.py",
                            "__name:=listen_py", stdout="py.log")]
        self.start("/usr/bin/python3", "-c", PUBLISHER)
        self.assertEqual(len(heard), 2)
        for log in ("cpp.log", "py.log"):
            self.wait_for(log, "The robot is in: kitchen")
            self.wait_for(log, "This frame shows kitchen (75 %)")

    def start(self, *command, stdout=os.devnull):
        with open(self.folder / stdout, "w") as out:
            process = subprocess.Popen([str(word) for word in command], stdout=out,
                                       stderr=subprocess.STDOUT)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, log, text):
        deadline = time.monotonic() + PATIENCE
        while text not in (self.folder / log).read_text():
            self.assertLess(time.monotonic(), deadline, (self.folder / log).read_text())
            time.sleep(0.1)


PUBLISHER = """
import socket, time, os
from urllib.parse import urlparse
master = urlparse(os.environ["ROS_MASTER_URI"])
while socket.socket().connect_ex((master.hostname, master.port)):
    time.sleep(0.1)
import rospy
from place_recognition.msg import PlaceRecognition
from std_msgs.msg import String
rospy.init_node("place_recognizer")
place = rospy.Publisher("~place", String, queue_size=1, latch=True)
place.publish("kitchen")
recognition = rospy.Publisher("~recognition", PlaceRecognition, queue_size=1)
while not rospy.is_shutdown():
    recognition.publish(PlaceRecognition(place="kitchen", known=True, confidence=0.75))
    time.sleep(0.2)
"""


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
