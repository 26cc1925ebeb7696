#!/usr/bin/env python3
"""Input to nodes that nobody should send, and parameters that nobody should set."""
import os
import sys
import unittest

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.msg import Config, DoubleParameter
from dynamic_reconfigure.srv import Reconfigure
from place_recognition.msg import PlaceRecognition
from place_recognition.srv import Retrain
from sensor_msgs.msg import Image
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from field_case import IMAGE, ROOMS, FieldCase  # noqa: E402
from node_case import PROGRAMS, SOURCE  # noqa: E402


class RecognizerCase(FieldCase):
    def start_recognizer(self, *arguments):
        self.model = self.train(self.write_run("run.bag"))
        node = self.start_node("place_recognizer", f"_model:={self.model}", IMAGE, "_lazy:=false",
                               *arguments)
        self.front = self.camera(compressed=False)
        self.heard = self.listen("/place_recognizer/recognition", PlaceRecognition)
        self.places = self.listen("/place_recognizer/place", String)
        self.wait_for(self.front.listeners, "nobody listens")
        return node

    def show(self, count=5):
        for _ in range(count):
            before = len(self.heard)
            self.front.send()
            self.wait_for(lambda: len(self.heard) > before, "no answer")


class RecognizerTest(RecognizerCase):
    def test_live_parameters_that_are_not_numbers_are_not_taken_over(self):
        node = self.start_recognizer()
        self.show()
        configure = rospy.ServiceProxy("/place_recognizer/set_parameters", Reconfigure)
        names = ("unknown_threshold", "smoothing", "maximum_rate", "embedding_rate", "deadline")
        before = {item.name: item.value for item in configure(Config()).config.doubles}
        nothing = [DoubleParameter(name, float("nan")) for name in names]
        after = configure(Config(doubles=nothing)).config.doubles
        self.assertEqual({item.name: item.value for item in after}, before)
        self.expect(node, *(f"~{name} is not a number" for name in names))
        self.show()
        self.assertEqual({place.data for place in self.places[-3:]} - {"unknown"}, {"kitchen"})

    def test_enabling_again_changes_nothing(self):
        self.start_recognizer()
        self.show()
        self.wait_for(lambda: self.places[-1].data == "kitchen", lambda: self.places)
        count = len(self.places)
        enable = rospy.ServiceProxy("/place_recognizer/set_enabled", SetBool)
        self.assertTrue(enable(True).success)
        self.show()
        self.assertEqual(len(self.places), count)

    def test_a_map_that_does_not_fit_is_reported_before_the_first_image(self):
        node = self.start_recognizer("_adjacency:=nowhere.yaml")
        self.expect(node, "the map of ~adjacency cannot be used")
        self.assertFalse(self.heard)

    def test_without_a_model_the_diagnostics_do_not_say_that_images_are_answered(self):
        self.start_node("place_recognizer", "_model:=none", IMAGE, "_lazy:=false")
        camera = self.camera(compressed=False)
        self.wait_for(camera.listeners, "nobody listens")
        reports = self.listen("/diagnostics", DiagnosticArray)

        def is_said():
            camera.send()
            return any("there is no model" in status.message for report in list(reports)
                       for status in report.status if "Images" in status.name)
        self.wait_for(is_said, lambda: reports)

    def test_each_camera_has_its_own_topic(self):
        for arguments in (["_cameras:=[front, /front/image_raw]"],
                          ["_cameras:=[front, rear]", "rear/image_raw:=front/image_raw"]):
            self.expect_end(self.start_node("place_recognizer", *arguments), 1,
                            "of ~cameras are the same topic, /front/image_raw")

    def test_cameras_change_their_models_together(self):
        for name in ("ma", "mb"):
            self.train(self.write_run("run.bag"), name)
        models = self.folder / "ros_home/place_recognition/models"
        self.start_node("place_recognizer", "_cameras:=[front, rear]", "_models:=[ma, mb]",
                        "_lazy:=false")
        front = self.camera("/front/image_raw", compressed=False)
        self.wait_for(front.listeners, "nobody listens")
        heard = self.listen("/place_recognizer/recognition", PlaceRecognition)

        def version():
            before = len(heard)
            front.send()
            self.wait_for(lambda: len(heard) > before, "no answer")
            return heard[-1].model_version
        first = version()
        program = self.start(os.environ["PLACE_TOOL"], "train", "run.bag", "--model", "ma",
                             "--config", "crfh")
        self.assertEqual(program.wait(), 0, program.output)
        (models / "mb.places").write_bytes(b"rubbish")
        reload_model = rospy.ServiceProxy("/place_recognizer/reload_model", Trigger)
        answer = reload_model()
        self.assertFalse(answer.success)
        self.assertIn("mb", answer.message)
        self.assertEqual(version(), first)

    def start_monitor(self):
        """Returns a monitor that has printed the name of the room."""
        self.start_recognizer("_image_timeout:=1")
        monitor = self.start(sys.executable, SOURCE / "scripts/place_monitor.py")
        self.wait_for(lambda: "place_monitor" in str(self.subscribers("/place_recognizer/belief")),
                      lambda: monitor.output)
        self.show(8)
        self.expect(monitor, "kitchen")
        return monitor

    def test_the_monitor_shows_that_the_camera_is_silent(self):
        self.expect(self.start_monitor(), "unknown")

    def test_the_monitor_shows_that_the_lens_is_covered(self):
        monitor = self.start_monitor()
        black = Image(height=96, width=128, encoding="bgr8", step=384, data=bytes(96 * 384))

        def is_shown():
            black.header.stamp = rospy.Time.now()
            self.front.publisher.publish(black)
            return "unknown" in monitor.output
        self.wait_for(is_shown, lambda: monitor.output)

    def test_the_monitor_says_that_nobody_answers(self):
        monitor = self.start(sys.executable, SOURCE / "scripts/place_monitor.py", "--recognizer", "/eyes")
        self.expect(monitor, "Nobody publishes /eyes/belief; start place_recognizer, or name it with "
                    "--recognizer.")
        self.assertEqual(monitor.interrupt(), 0)

    def subscribers(self, topic):
        _, subscribers, _ = rospy.get_master().getSystemState()[2]
        return [nodes for name, nodes in subscribers if name == topic]


class LabelerTest(FieldCase):
    def test_images_of_impossible_times(self):
        (self.folder / "rooms.yaml").write_text(ROOMS)
        node = self.start_node("auto_labeler", "_bag:=run", "_rooms:=rooms.yaml", IMAGE)
        camera = self.camera(compressed=False)
        self.wait_for(camera.listeners, "nobody listens")
        for stamp in (rospy.Time(100), rospy.Time(2 ** 32 - 1), rospy.Time(101)):
            camera.send(stamp)
            rospy.sleep(0.2)
        rospy.sleep(0.5)
        self.assertEqual(node.interrupt(), 0, node.output)
        self.assertIn("run.bag: 3 images", node.output)

    def test_images_that_cannot_be_learned(self):
        node = self.start_node("place_labeler", "_bag:=run", IMAGE, "_places:=[kitchen]")
        camera = self.camera(compressed=False)
        self.wait_for(camera.listeners, "nobody listens")
        camera.publisher.publish(Image(height=4, width=4, encoding="32FC4", step=64,
                                       data=bytes(256)))
        self.expect(node, "Images on /camera/image_raw are recorded but cannot be learned", "32FC4")

    def test_a_node_has_a_name_without_a_namespace(self):
        for name in ("robot/labeler", "~labeler"):
            self.expect_end(self.start(PROGRAMS / "place_labeler", f"__name:={name}"), 1,
                            f"place_labeler: Invalid node name [{name}]", "__ns:=NAMESPACE")

    def test_a_button_has_one_meaning(self):
        for options in (["_no_place_button:=1"], ["_buttons:=[2, 2]"]):
            node = self.start_node("place_labeler", "_bag:=run", "_places:=[kitchen, hall]", *options)
            self.expect_end(node, 1, "~buttons", "twice")


class TrainerTest(FieldCase):
    def test_messages_name_what_the_caller_has_written(self):
        self.write_run("run.bag")
        self.start_node("trainer", f"_bag_roots:=[{self.folder}]")
        retrain = rospy.ServiceProxy("/trainer/retrain", Retrain)
        retrain.wait_for_service(60)
        bag = str(self.folder / "run.bag")
        answer = retrain(bags=[bag], model="home", yaml="foo: 1")
        self.assertFalse(answer.success)
        self.assertIn("yaml of the goal", answer.message)
        self.assertNotIn("/tmp", answer.message.replace(str(self.folder), ""))
        answer = retrain(bags=[bag], model="home", add_to="home", from_model="home")
        self.assertIn("from_model and add_to name the same model", answer.message)
        self.assertNotIn("--help", answer.message)
        self.assertIn("empty name", retrain(bags=[bag], model="home", recognizers=[""]).message)


if __name__ == "__main__":
    unittest.main()
