#!/usr/bin/env python3
"""What the launch files make of their arguments."""
import os
import pathlib
import unittest

import roslaunch.config

LAUNCH = pathlib.Path(os.environ["PLACE_RECOGNITION_SOURCE_DIR"]) / "launch"
# Arguments of recognize.launch whose default is none.
TEXTS = ("cameras", "models", "camera_correlation", "adjacency", "keep_doubtful")
NAMES = ("007", "1.50", "true", "none_", "a 'b'")  # the first three could be read as values


def read(file, *arguments):
    """Returns the configuration that roslaunch reads from a launch file of the package."""
    path = str(LAUNCH / file)
    return roslaunch.config.load_config_default([(path, list(arguments))], None, assign_machines=False)


def parameters(file, *arguments):
    """Returns the values of the parameters, by name."""
    return {name: parameter.value for name, parameter in read(file, *arguments).params.items()}


class ArgumentsTest(unittest.TestCase):
    def test_names_are_passed_on_as_they_are_written(self):
        for name in NAMES:
            with self.subTest(name):
                values = parameters("recognize.launch", f"model:={name}")
                self.assertEqual(values["/place_recognizer/model"], name)
                values = parameters("recognize.launch", *(f"{argument}:={name}" for argument in TEXTS))
                for argument in TEXTS:
                    self.assertEqual(values[f"/place_recognizer/{argument}"], name, argument)
                values = parameters("auto_record.launch", f"bag:={name}", "rooms:=rooms.yaml")
                self.assertEqual(values["/auto_labeler/bag"], name)

    def test_none_is_an_empty_parameter(self):
        values = parameters("recognize.launch")
        for argument in TEXTS:
            self.assertEqual(values[f"/place_recognizer/{argument}"], "", argument)
        self.assertEqual(values["/place_recognizer/model"], "rooms")
        self.assertEqual(parameters("recognize.launch", "models:=[a, b]")["/place_recognizer/model"], "")
        self.assertEqual(parameters("auto_record.launch", "rooms:=a")["/auto_labeler/bag"], "")

    def test_odometry_is_remapped_to_the_topic_as_it_is_written(self):
        for manager in ("none", "manager"):
            for topic in ("none", "odometry/filtered", "true"):
                with self.subTest(manager=manager, topic=topic):
                    arguments = (f"manager:={manager}", f"odometry:={topic}")
                    config = read("recognize.launch", *arguments)
                    remapped = dict(config.nodes[0].remap_args)
                    self.assertEqual(remapped.get("odom", "odom"), "odom" if topic == "none" else topic)
                    self.assertEqual(config.params["/place_recognizer/use_odometry"].value, topic != "none")

    def test_a_node_ends_the_launch_or_is_restarted(self):
        for file, *arguments in (("recognize.launch",), ("recognize.launch", "manager:=manager"),
                                 ("train.launch",), ("relocalize.launch", "rooms:=rooms.yaml")):
            for required in ("true", "false"):
                with self.subTest(file, arguments=arguments, required=required):
                    node = read(file, *arguments, f"required:={required}").nodes[0]
                    self.assertEqual((node.required, node.respawn), (required == "true", required == "false"))


if __name__ == "__main__":
    unittest.main()
