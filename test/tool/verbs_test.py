#!/usr/bin/env python3
"""Tests the other verbs of place_tool on painted rooms, as used by people and by programs."""
import unittest

import cv2
from tool_case import ROOMS, ToolCase, paint
from trained_case import TrainedCase


class FeaturesTest(ToolCase):
    def test_a_histogram_sums_to_one_and_its_indices_ascend(self):
        self.write_image("a.png", paint("kitchen", 0))
        pairs = [pair.split(":") for pair in self.succeed("features", "a.png").split()]
        indices = [int(index) for index, _ in pairs]
        self.assertEqual(indices, sorted(set(indices)))
        self.assertAlmostEqual(sum(float(value) for _, value in pairs), 1, places=5)

    def test_several_cues_are_told_apart(self):
        self.write_image("a.png", paint("kitchen", 0))
        (self.folder / "two.yaml").write_text(
            "cues:\n"
            "  - {name: shape, feature: {type: crfh, descriptors: [Lxx]}}\n"
            "  - {name: colour, feature: {type: crfh, descriptors: [C1]}}\n")
        lines = self.succeed("features", "a.png", "--config", "two.yaml").splitlines()
        self.assertEqual((lines[0], lines[2], len(lines)), ("# shape", "# colour", 4))


class InfoTest(TrainedCase):
    def test_model(self):
        figures = self.figures("info", "./home.places")
        self.assertEqual(figures["inputs"], ["monday"])
        self.assertEqual(figures["rooms"], {room: {"count": 8} for room in sorted(ROOMS)})
        text = self.succeed("info", "./home.places")
        for words in ("monday", "version", "[L, C1, C2]", *ROOMS):
            self.assertIn(words, text)

    def test_bag(self):
        self.write_bag("run.bag", [("kitchen", "kitchen"), ("kitchen", None), ("office", "office")])
        figures = self.figures("info", "run.bag")
        topics = {topic["name"]: topic for topic in figures["topics"]}
        images = topics["/camera/image_raw/compressed"]
        self.assertEqual((images["messages"], images["width"], images["height"]), (3, 128, 96))
        self.assertEqual([(label["from"], label["to"], label["place"])
                          for label in figures["labels"]],
                         [(0, 2, "kitchen"), (2, 2, "office")])
        self.assertIn("kitchen", self.succeed("info", "run.bag"))

    def test_labels_that_do_not_fit_hide_nothing_of_a_bag(self):
        self.write_bag("run.bag", [("kitchen", None)] * 6)
        labels = self.folder / "run.labels.yaml"
        for intervals, status, words in (
                ("{from: 0, to: 2, place: kitchen}, {from: 90, to: 99, place: office}", 0,
                 "warning: run.labels.yaml: 1 interval lies outside the bag"),
                ("{from: 90, to: 99, place: office}", 1,
                 "place_tool info: run.labels.yaml: no label falls into the bag"),
                ("{from: 0, to: 9, plaice: office}", 1,
                 "place_tool info: Unknown option 'plaice' in 'run.labels.yaml")):
            labels.write_text(f"labels: [{intervals}]\n")
            result = self.run_tool("info", "run.bag")
            self.assertEqual(result.returncode, status, result.stderr)
            self.assertTrue(result.stderr.startswith(words), result.stderr)
            self.assertEqual(len(result.stderr.splitlines()), 1)
            self.assertIn("6  /camera/image_raw/compressed", result.stdout)
            self.assertEqual("kitchen" in result.stdout, status == 0)

    def test_an_interval_outside_a_bag_is_told_once(self):
        self.write_bag("run.bag", [("kitchen", None)] * 6)
        (self.folder / "run.labels.yaml").write_text(
            "labels: [{from: 0, to: 4, place: corridor}, {from: 90, to: 99, place: kitchen}]\n")
        said = self.run_tool("evaluate", "run.bag", "--model", "./home.places").stderr
        self.assertIn("1 interval lies outside the bag", said)
        self.assertNotIn("is not used", said)


class SimulateTest(ToolCase):
    SMALL = ("--conditions", "night", "--size", "32x24")

    def test_bag_and_folder_show_the_same_rooms(self):
        bag = self.figures("simulate", "--out", "runs", *self.SMALL)["runs"][0]
        folder = self.figures("simulate", "--out", "runs", "--format", "images",
                              *self.SMALL)["runs"][0]
        self.assertEqual(bag["rooms"], folder["rooms"])
        self.assertEqual(len(bag["rooms"]), 5)
        pictures = list((self.folder / "runs/night").glob("*/*.png"))
        self.assertEqual(len(pictures), folder["images"])
        self.assertEqual(cv2.imread(str(pictures[0])).shape, (24, 32, 3))
        topics = self.figures("info", "runs/night.bag")["topics"]
        self.assertIn(bag["images"], [topic["messages"] for topic in topics])


if __name__ == "__main__":
    unittest.main()
