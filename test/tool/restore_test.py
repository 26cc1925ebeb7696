#!/usr/bin/env python3
"""Earlier models of a name are listed and restored."""
import unittest

from tool_case import ROOMS, ToolCase

COLOUR = ("--config", "crfh_colour")


class RestoreTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("monday")
        rooms = sorted(ROOMS)
        self.write_run("tuesday", rooms=rooms[:2])
        self.succeed("train", "monday", "--model", "home", *COLOUR)

    def rooms(self):
        return list(self.figures("info", "home")["rooms"])

    def test_the_newest_backup_unless_told_otherwise(self):
        self.succeed("train", "tuesday", "--model", "home", *COLOUR)
        self.assertEqual(len(self.rooms()), 2)
        text = self.succeed("restore", "home")
        self.assertIn("in use again; the replaced model is now backup 1", text)
        self.assertEqual(len(self.rooms()), 3)
        self.succeed("restore", "home")  # and back
        self.assertEqual(len(self.rooms()), 2)

    def test_after_the_model_was_removed(self):
        self.succeed("train", "tuesday", "--model", "./home.places", *COLOUR)
        self.succeed("train", "monday", "--model", "./home.places", *COLOUR)
        (self.folder / "home.places").unlink()
        text = self.succeed("restore", "./home.places")
        self.assertIn("in use again. Running", text)

    def test_three_are_kept_and_listed(self):
        for _ in range(4):
            self.succeed("train", "tuesday", "--model", "home", *COLOUR)
        models = self.figures("restore", "home", "--list")["models"]
        self.assertEqual([model["age"] for model in models], [0, 1, 2, 3])
        self.assertEqual([len(model["rooms"]) for model in models], [2, 2, 2, 2])
        self.assertIn("backup 3", self.succeed("restore", "home", "--list"))

    def test_no_version_is_lost_or_kept_twice(self):
        rooms = sorted(ROOMS)
        for run, named in (("tuesday", rooms[:2]), ("friday", rooms[1:3])):
            self.write_run(run, rooms=named)
            self.succeed("train", run, "--model", "home", *COLOUR)
        self.succeed("train", "monday", "--model", "home", *COLOUR, "--set", "svm.c=7")

        def versions():
            models = self.figures("restore", "home", "--list")["models"]
            return [model["version"] for model in models]
        a, b, c, d = versions()
        for age, expected in ((1, [b, a, c, d]), (1, [a, b, c, d]), (3, [d, a, b, c]),
                              (2, [b, d, a, c])):
            self.succeed("restore", "home", "--age", age)
            self.assertEqual(versions(), expected)
        models = self.folder / "ros_home/place_recognition/models"
        (models / "home.places").unlink()
        self.succeed("restore", "home", "--age", 2)
        self.assertEqual(versions(), [a, d, c])
        self.assertFalse((models / "home.places.4").exists())

    def test_what_cannot_be_restored(self):
        for age in (1, 2):
            self.assertIn("home.places has no earlier version", self.refuse("restore", "home", "--age", age))
        self.assertIn("There is no model", self.refuse("restore", "absent"))
        self.assertIn("absent", self.refuse("restore", "absent", "--list"))
        self.refuse("restore", "home", "--age", "4", status=2)
        models = self.folder / "ros_home/place_recognition/models"
        (models / "home.places.1").write_bytes(b"no model")
        self.assertIn("home.places has no backup 2; place_tool restore --list",
                      self.refuse("restore", "home", "--age", 2))
        self.assertIn("home.places.1", self.refuse("restore", "home"))
        self.assertIn("not a place_recognition model", self.succeed("restore", "home", "--list"))
        self.assertEqual(len(self.rooms()), 3)


if __name__ == "__main__":
    unittest.main()
