#!/usr/bin/env python3
"""Tests place_tool built without ROS: every verb on folders of images, and the refusal of a bag."""
import unittest

from tool_case import ROOMS, ToolCase, paint

MODEL = ("--model", "./home.places")


class NoBagsTest(ToolCase):
    def test_verbs_on_folders(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.succeed("train", "monday", *MODEL, "--config", "crfh_colour")
        picture = self.write_image("now.png", paint("office", 1))
        self.assertIn("office", self.succeed("recognize", picture, *MODEL))
        self.assertEqual(self.figures("evaluate", "tuesday", *MODEL)["average_rate"], 1)
        reduced = self.figures("reduce", *MODEL, "--out", "./small.places", "--share", "0.5")
        self.assertLess(reduced["support_vectors_after"], reduced["support_vectors_before"])
        self.assertEqual(set(self.figures("info", "./home.places")["rooms"]), set(ROOMS))
        self.assertIn(":", self.succeed("features", picture))

    def test_simulate_to_images(self):
        run = self.figures("simulate", "--out", "runs", "--conditions", "night", "--size", "32x24",
                           "--format", "images")["runs"][0]
        self.assertEqual(len(list((self.folder / "runs/night").glob("*/*.png"))), run["images"])

    def test_a_bag_is_refused_with_the_remedy(self):
        (self.folder / "run.bag").write_bytes(b"#ROSBAG V2.0\n")
        self.write_run("monday")
        for arguments in (("train", "run.bag", *MODEL), ("info", "run.bag"),
                          ("import", "monday", "--out", "new.bag"),
                          ("tune", "run.bag", "--out", "found.yaml")):
            self.assertIn("PLACE_RECOGNITION_ROS=ON", self.refuse(*arguments))


if __name__ == "__main__":
    unittest.main()
