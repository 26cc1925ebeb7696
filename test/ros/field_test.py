#!/usr/bin/env python3
"""Nodes with full disks, differing clocks, infrared cameras, and two nodelets in one manager."""
import os
import pathlib
import signal
import sys
import threading
import unittest

import cv2
import numpy as np
import rosbag
import rospy
from place_recognition.msg import PlaceRecognition
from place_recognition.srv import Retrain
from sensor_msgs.msg import Image
from std_msgs.msg import String

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from field_case import IMAGE, ROOMS, FieldCase  # noqa: E402
from node_case import PROGRAMS, paint  # noqa: E402


class FullDiskTest(FieldCase):
    """Simulates a full disk by a limit on the size of files: the kernel refuses to write more."""

    def start_on_small_disk(self, kilobytes, node, *arguments):
        return self.start("prlimit", f"--fsize={kilobytes * 1024}", PROGRAMS / node,
                          f"__name:={node}", *arguments)

    def test_recorders_end_with_a_sentence_and_keep_what_can_be_rescued(self):
        (self.folder / "rooms.yaml").write_text(ROOMS)
        for node, arguments in (("place_labeler", []), ("auto_labeler", ["_rooms:=rooms.yaml"])):
            with self.subTest(node):
                bag = self.folder / f"{node}.bag"
                camera = self.camera(compressed=False)
                # rosbag writes a chunk of 768 KB at a time.
                program = self.start_on_small_disk(1200, node, f"_bag:={bag}", IMAGE, *arguments)
                self.wait_for(camera.listeners, "nobody listens")
                self.wait_for(lambda: camera.send() or program.process.poll() is not None,
                              lambda: program.output)
                self.expect_end(program, 1, f"Cannot write {bag}", "make room",
                                f"rosbag reindex {bag}.active, and rename it to {bag} "
                                f"({bag}.orig.active is its backup)")
                self.assertNotIn("terminate called", program.output)
                self.assertFalse(bag.exists())
                camera.close()
                rescue = self.start("rosbag", "reindex", f"{bag}.active")
                self.assertEqual(rescue.wait(), 0, rescue.output)
                self.assertTrue(pathlib.Path(f"{bag}.orig.active").exists())
                with rosbag.Bag(f"{bag}.active") as rescued:
                    self.assertGreater(rescued.get_message_count(), 10)

    def test_a_recorder_that_cannot_even_start(self):
        program = self.start_on_small_disk(0, "place_labeler", "_bag:=run.bag", IMAGE)
        self.assertEqual(program.wait(), 1)
        self.assertEqual(list(self.folder.glob("run.bag*")), [])

    def test_the_trainer_refuses_and_goes_on(self):
        self.write_run("run.bag")
        self.start_on_small_disk(3, "trainer", f"_bag_roots:=[{self.folder}]")
        rospy.wait_for_service("/trainer/retrain", 60)
        retrain = rospy.ServiceProxy("/trainer/retrain", Retrain)
        for _ in range(2):
            answer = retrain(bags=[str(self.folder / "run.bag")], model="home", preset="crfh_colour")
            self.assertFalse(answer.success)
            self.assertIn("Cannot write", answer.message)
            self.assertIn("make room", answer.message)
        self.assertEqual([path for path in (self.folder / "ros_home").rglob("*")
                          if "places" in path.name], [])


class TrainerTest(FieldCase):
    def test_warnings_reach_the_client_and_the_log(self):
        whole, part = self.folder / "run_0.bag", self.folder / "run_1.bag"
        self.write_run(whole.name)
        with rosbag.Bag(str(part), "w") as later:
            for i in range(16, 23):
                image = Image(height=96, width=128, encoding="bgr8", step=384,
                              data=paint("office", i).tobytes())
                image.header.stamp = rospy.Time(1000 + i)
                later.write("/image", image, image.header.stamp)
        node = self.start_node("trainer", f"_bag_roots:=[{self.folder}]")
        rospy.wait_for_service("/trainer/retrain", 60)
        retrain = rospy.ServiceProxy("/trainer/retrain", Retrain)

        def ask(*bags):
            return retrain(bags=[str(bag) for bag in bags], model="home", preset="crfh_colour")

        alone = ask(part)
        self.assertFalse(alone.success)
        self.assertIn("rosbag record --repeat-latched", alone.message)
        both = ask(part, whole)
        self.assertEqual((both.success, both.images), (True, 23), both.message)
        self.assertIn("/run_1.bag has no labels.", node.output)
        self.assertIn(f"{part} continues where {whole} ends", both.message)
        self.assertIn(f"{part} continues where {whole} ends, and starts in 'office'", node.output)
        self.assertIn("is a folder; name the bags in it", ask(self.folder).message)
        self.assertEqual(node.interrupt(), 0)


class EndTest(FieldCase):
    def test_a_training_by_a_service_does_not_hold_the_trainer_up(self):
        run = str(self.folder / self.write_run("run.bag"))
        for number in (signal.SIGINT, signal.SIGHUP):
            node = self.start_node("trainer", f"_bag_roots:=[{self.folder}]")
            rospy.wait_for_service("/trainer/retrain", 60)
            retrain = rospy.ServiceProxy("/trainer/retrain", Retrain)

            def ask():
                try:
                    retrain(bags=[run] * 20, model="home")
                except rospy.ServiceException:
                    pass  # the trainer may be gone before it can answer

            caller = threading.Thread(target=ask)
            caller.start()
            self.expect(node, "Looking at the images")
            node.process.send_signal(number)
            self.assertEqual(node.process.wait(30), 0, node.output)
            self.assertIn("Training failed: Cancelled", node.output)
            caller.join(30)
            self.assertEqual(list((self.folder / "ros_home").rglob("*.places*")), [])


class StampsTest(FieldCase):
    def test_every_frame_is_answered_whatever_its_stamp(self):
        model = self.train(self.write_run("run.bag"))
        node = self.start_node("place_recognizer", f"_model:={model}", "image:=/camera/image_raw",
                               "_lazy:=false")
        camera = self.camera(compressed=False)
        self.wait_for(camera.listeners, "nobody listens")
        heard = self.listen("/place_recognizer/recognition", PlaceRecognition)
        places = self.listen("/place_recognizer/place", String)
        now = rospy.Time.now()
        second = rospy.Duration(1)
        stamps = [now, now + 2 * second, now + 2 * second, now - 2 * second, now + second,
                  rospy.Time(0), rospy.Time(0, 1), now, rospy.Time(2 ** 32 - 1), now]
        for i, stamp in enumerate(stamps):
            message = camera.message()
            message.header.stamp = stamp
            camera.publisher.publish(message)
            self.wait_for(lambda: len(heard) > i, lambda: f"{stamp} unanswered: {node.output}")
            self.assertEqual((heard[i].header.stamp, heard[i].place), (stamp, "kitchen"))
        self.wait_for(lambda: any(place.data == "kitchen" for place in places), lambda: places)
        self.assertEqual(node.interrupt(), 0)

    def test_a_camera_whose_clock_differs_by_two_seconds_is_recorded_and_learned(self):
        (self.folder / "rooms.yaml").write_text(ROOMS)
        for skew in (2, -2):
            camera = self.camera()
            node = self.start_node("auto_labeler", "_rooms:=rooms.yaml", f"_bag:=run{skew}.bag", IMAGE,
                                   "_image_transport:=compressed")
            self.wait_for(camera.listeners, "nobody listens")
            for _ in range(20):
                camera.send(rospy.Time.now() + rospy.Duration(skew))
                rospy.sleep(0.02)
            self.expect(node, "Recording")
            rospy.sleep(3)
            self.assertEqual(node.interrupt(), 0, node.output)
            self.assertIn("20 images", node.output)
            camera.close()


class InfraredTest(FieldCase):
    def test_the_range_of_the_model_is_used(self):
        def infrared(room, view, share):
            grey = cv2.cvtColor(paint(room, view), cv2.COLOR_BGR2GRAY).astype(np.float64)
            return Image(height=96, width=128, encoding="mono16", step=256,
                         data=np.minimum(grey * 4 * share, 1023).astype("<u2").tobytes())

        with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            for i in range(16):
                room = ("kitchen", "office")[i // 8]
                if i % 8 == 0:
                    bag.write("/place_label", String(room), rospy.Time(1000 + i))
                bag.write("/image", infrared(room, i, 1.2), rospy.Time(1000 + i))
        model = self.train("run.bag")
        node = self.start_node("place_recognizer", f"_model:={model}", "image:=/infra", "_lazy:=false")
        publisher = rospy.Publisher("/infra", Image, queue_size=1)
        self.addCleanup(publisher.unregister)
        self.wait_for(publisher.get_num_connections, "nobody listens")
        publisher.publish(infrared("kitchen", 1, .4))
        self.expect(node, "Images with 16 bits are converted to 8: 0 .. 1023 of 16 bits, as in training.")
        self.assertEqual(node.interrupt(), 0)


class TwoNodeletsTest(FieldCase):
    def test_two_recognizers_in_one_manager_have_a_model_and_a_camera_each(self):
        with rosbag.Bag(str(self.folder / "other.bag"), "w") as bag:
            for i in range(16):
                room = ("corridor", "office")[i // 8]
                if i % 8 == 0:
                    bag.write("/place_label", String(room), rospy.Time(1000 + i))
                bag.write("/image", Image(height=96, width=128, encoding="bgr8", step=384,
                                          data=paint(room, i).tobytes()), rospy.Time(1000 + i))
        models = {"front": self.train(self.write_run("run.bag"), "home"),
                  "rear": self.train("other.bag", "other")}
        manager = self.start(os.environ["PLACE_RECOGNITION_NODELET_MANAGER"], "__name:=manager")
        cameras, heard = {}, {}
        for name, model in models.items():
            self.launch("recognize.launch", "manager:=manager", f"name:={name}", f"model:={model}",
                        f"image:=/{name}/image_raw", "lazy:=false")
            cameras[name] = self.camera(f"/{name}/image_raw", compressed=False)
            self.wait_for(cameras[name].listeners, "nobody listens")
            heard[name] = self.listen(f"/{name}/recognition", PlaceRecognition)
        for _ in range(5):
            for name, camera in cameras.items():
                before = len(heard[name])
                camera.send()
                self.wait_for(lambda: len(heard[name]) > before, lambda: manager.output)
        for name, other in (("front", "kitchen"), ("rear", "corridor")):
            self.assertEqual({message.model_name for message in heard[name]}, {models[name]})
            self.assertEqual({place.name for message in heard[name] for place in message.places},
                             {other, "office"})
            self.assertEqual(len(heard[name]), 5)
        self.assertEqual({message.place for message in heard["front"]}, {"kitchen"})


if __name__ == "__main__":
    unittest.main()
