#!/usr/bin/env python3
"""Tests that Train.action offers the same options as the command line of place_tool train."""
import os
import pathlib
import re
import subprocess
import unittest

ACTION = pathlib.Path(os.environ["PLACE_RECOGNITION_SOURCE_DIR"]) / "action/Train.action"

# Fields that are passed under other names (src/ros/trainer/train_command.cpp), or not at all.
NO_OPTIONS = {"bags", "preset", "yaml", "reduction", "vector_limit", "calibrate", "recognizers"}
# Options that a goal specifies otherwise, or that the trainer sets itself.
NO_FIELDS = {"config", "set", "limit", "help", "json", "progress",
             "labels"}  # a file; one beside a bag is found automatically


def fields():
    goal = ACTION.read_text().split("---")[0]
    return set(re.findall(r"^\w+(?:\[\])? +(\w+)", goal, re.MULTILINE))


def options():
    text = subprocess.run([os.environ["PLACE_TOOL"], "train", "--help"], text=True, check=True,
                          capture_output=True).stdout
    return {name.replace("-", "_") for name in re.findall(r"^  (?:-\w, )?--([\w-]+)", text, re.MULTILINE)}


class TrainFieldsTest(unittest.TestCase):
    def test_every_field_is_an_option(self):
        for name in sorted(fields() - options() - NO_OPTIONS):
            self.fail(f"Train.action has the field {name}, but place_tool train has no --{name}: add the "
                      "option, or hand the field on in train_command.cpp and name it in NO_OPTIONS.")

    def test_every_option_is_a_field(self):
        for name in sorted(options() - fields() - NO_FIELDS):
            self.fail(f"place_tool train has the option {name}, but Train.action has no such field: add it, "
                      "or name the option in NO_FIELDS with the reason.")

    def test_the_exceptions_exist(self):
        self.assertLessEqual(NO_OPTIONS, fields() - options())
        self.assertLessEqual(NO_FIELDS, options() - fields())


if __name__ == "__main__":
    unittest.main()
