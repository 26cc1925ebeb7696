#!/usr/bin/env python3
"""The messages of nodes that receive no clock, image or pose, and their last messages."""
import os
import signal
import subprocess
import sys
import unittest

import rosbag
import rospy
from place_recognition.srv import SayPlace
from rosgraph_msgs.msg import Clock

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import Camera, NodeCase  # noqa: E402

IMAGE = "image:=/camera/image_raw"
ROOMS = "places: [{name: kitchen, position: [[0, 0], [4, 0], [4, 3]]}]"


def size(path):
    """Returns the size in bytes of a file that may not exist yet."""
    try:
        return path.stat().st_size
    except FileNotFoundError:
        return 0


class SilenceTest(NodeCase):
    def camera(self, *arguments, **options):
        camera = Camera(*arguments, **options)
        self.addCleanup(camera.close)
        return camera

    def test_a_recognizer_that_hears_nothing_says_so_once(self):
        self.camera("/front/image_raw")
        node = self.start_node("place_recognizer", "image:=/front/image_raw", "_lazy:=false",
                               "_image_timeout:=1")
        self.expect(node, "No image has arrived on /front/image_raw for 1 s. "
                    "/front/image_raw/compressed is published", "set ~image_transport to compressed")
        rospy.sleep(2.5)
        self.assertEqual(node.output.count("No image has arrived"), 1, node.output)
        node.interrupt()

    def test_a_lazy_recognizer_without_listeners_says_nothing(self):
        node = self.start_node("place_recognizer", IMAGE, "_image_timeout:=0.5")
        self.expect(node, "no model to recognize with")
        rospy.sleep(2)
        self.assertNotIn("No image has arrived", node.output)
        self.assertEqual(node.interrupt(), 0)

    def test_a_recorder_that_hears_nothing_names_the_topics_that_there_are(self):
        self.camera("/front/image_raw", compressed=False)
        node = self.start_node("place_labeler", "_bag:=run.bag", IMAGE)
        self.expect(node, "Nobody publishes /camera/image_raw.", "/front/image_raw")
        self.assertEqual(node.interrupt(), 1)
        self.assertIn("No image has arrived on /camera/image_raw. Nothing was recorded.", node.output)
        self.assertFalse(list(self.folder.glob("run.bag*")))


class ClockTest(NodeCase):
    def setUp(self):
        super().setUp()
        rospy.set_param("/use_sim_time", True)
        self.addCleanup(rospy.set_param, "/use_sim_time", False)

    def test_every_node_says_that_there_is_no_clock(self):
        (self.folder / "rooms.yaml").write_text(ROOMS)
        nodes = [self.start_node("place_recognizer"), self.start_node("trainer"),
                 self.start_node("place_labeler"), self.start_node("auto_labeler", "_rooms:=rooms.yaml"),
                 self.start_node("place_to_pose", "_rooms:=rooms.yaml")]
        for node in nodes:
            self.expect(node, "/use_sim_time is true, but no /clock has arrived",
                        "rosparam set /use_sim_time false")
            self.assertEqual(node.interrupt(), 0)

    def test_a_recorder_counts_the_images_that_came_without_a_clock(self):
        camera = Camera()
        self.addCleanup(camera.close)
        node = self.start_node("place_labeler", "_bag:=run.bag", IMAGE, "_image_transport:=compressed")
        self.wait_for(camera.listeners, "nobody listens")
        camera.send()
        self.expect(node, "1 images have arrived but cannot be recorded", "there is no /clock")
        self.assertNotIn("No image has arrived", node.output)
        self.assertEqual(node.interrupt(), 1)
        self.assertIn("Nothing was recorded.", node.output)

    def test_a_recorder_keeps_each_label_though_the_clock_jumps_back_and_stands_still(self):
        clock = rospy.Publisher("/clock", Clock, queue_size=1, latch=True)
        self.addCleanup(clock.unregister)
        camera = Camera()
        self.addCleanup(camera.close)
        clock.publish(Clock(rospy.Time(1000)))
        node = self.start_node("place_labeler", "_bag:=run.bag", IMAGE, "_image_transport:=compressed")
        say = rospy.ServiceProxy("/place_labeler/say", SayPlace)
        say.wait_for_service(60)
        self.wait_for(camera.listeners, "nobody listens")
        said = ("kitchen", "office", "corridor")
        for place, times in zip(said, ((1001, 1002, 900, 901), (902, 902, 902), (902, 902, 950))):
            say(place)
            for time in times:
                clock.publish(Clock(rospy.Time(time)))
                rospy.rostime.wallsleep(.2)
                camera.send()
                rospy.rostime.wallsleep(.2)
        self.assertEqual(node.interrupt(), 0, node.output)
        self.assertIn("Time has jumped back by 102.0 s; the recording continues", node.output)
        frames, place = [], None
        with rosbag.Bag(str(self.folder / "run.bag")) as bag:
            for topic, message, _ in bag.read_messages():
                if topic == "/place_label":
                    place = message.data
                else:
                    frames.append(place)
        self.assertEqual(frames, ["kitchen"] * 4 + ["office"] * 3 + ["corridor"] * 3)

    def test_recorders_record_at_times_whose_difference_exceeds_a_duration(self):
        (self.folder / "rooms.yaml").write_text(ROOMS)
        clock = rospy.Publisher("/clock", Clock, queue_size=1, latch=True)
        self.addCleanup(clock.unregister)
        for node, *arguments in (("place_labeler",), ("auto_labeler", "_rooms:=rooms.yaml")):
            with self.subTest(node):
                camera = Camera()
                program = self.start_node(node, f"_bag:={node}.bag", IMAGE,
                                          "_image_transport:=compressed", *arguments)
                self.wait_for(camera.listeners, "nobody listens")
                for time in (10, 11, 3e9, 3e9 + 1, 10, 11):
                    clock.publish(Clock(rospy.Time(int(time))))
                    rospy.rostime.wallsleep(.2)
                    camera.send()
                    rospy.rostime.wallsleep(.2)
                camera.close()
                self.assertEqual(program.interrupt(), 0, program.output)
                self.assertIn(f"{node}.bag: 6 images.", program.output)
                self.assertNotIn("cannot be handled", program.output)
                with rosbag.Bag(str(self.folder / f"{node}.bag")) as bag:
                    times = [round(time.to_sec()) for _, _, time in
                             bag.read_messages("/camera/image_raw/compressed")]
                self.assertEqual(times, [10, 11, 3e9, 3e9 + 1, 3e9 + 1, 3e9 + 2])

    def test_a_clock_is_no_reason_to_complain(self):
        clock = rospy.Publisher("/clock", Clock, queue_size=1, latch=True)
        self.addCleanup(clock.unregister)
        clock.publish(Clock(rospy.Time(1000)))
        node = self.start_node("place_labeler")
        self.expect(node, "There is no terminal")
        rospy.rostime.wallsleep(6)
        self.assertNotIn("/clock", node.output)
        self.assertEqual(node.interrupt(), 0)


class LastWordsTest(NodeCase):
    def record(self, *arguments):
        """Returns a recorder that has recorded ten images from a camera that is gone."""
        camera = Camera()
        self.addCleanup(camera.close)
        node = self.start_node("place_labeler", "_bag:=run.bag", IMAGE, "_image_transport:=compressed",
                               *arguments)
        self.wait_for(camera.listeners, "nobody listens")
        for _ in range(10):
            camera.send()
        bag = self.folder / "run.bag.active"
        self.wait_for(lambda: size(bag) > 10000, "nothing is recorded")
        rospy.sleep(0.5)
        camera.close()  # otherwise the next camera counts this recorder as a listener
        return node

    def test_the_count_is_said_however_the_node_is_ended(self):
        for end in (lambda node: node.process.send_signal(signal.SIGINT),
                    lambda node: node.process.send_signal(signal.SIGTERM),
                    lambda node: node.process.send_signal(signal.SIGHUP),  # the terminal closes
                    lambda node: subprocess.run(["rosnode", "kill", "/place_labeler"], check=True,
                                                stdout=subprocess.DEVNULL)):
            node = self.record()
            end(node)
            self.expect_end(node, 0, f"{self.folder}/run.bag: 10 images.")
            with rosbag.Bag(str(self.folder / "run.bag")) as bag:
                self.assertEqual(bag.get_message_count("/camera/image_raw/compressed"), 10)
            (self.folder / "run.bag").unlink()

    def test_a_bag_that_cannot_be_completed_is_an_error(self):
        node = self.record()
        (self.folder / "run.bag").mkdir()
        (self.folder / "run.bag/occupied").touch()
        self.assertEqual(node.interrupt(), 1)
        self.assertIn(f"Cannot write {self.folder}/run.bag", node.output)


class PoselessTest(NodeCase):
    def test_every_image_is_recorded_without_a_pose(self):
        (self.folder / "rooms.yaml").write_text(ROOMS)
        camera = Camera()
        self.addCleanup(camera.close)
        node = self.start_node("auto_labeler", "_rooms:=rooms.yaml", "_bag:=run.bag", IMAGE,
                               "_image_transport:=compressed", "_pose_timeout:=0.5")
        self.wait_for(camera.listeners, "nobody listens")
        rospy.sleep(0.5)
        rate = rospy.Rate(60)
        for _ in range(180):
            camera.send()
            rate.sleep()
        rospy.sleep(0.5)
        self.assertEqual(node.interrupt(), 0, node.output)
        self.assertIn("run.bag: 180 images", node.output)
        self.assertIn("None of 180 images has a label. No label because there is no pose: nobody publishes tf",
                      node.output)


if __name__ == "__main__":
    unittest.main()
