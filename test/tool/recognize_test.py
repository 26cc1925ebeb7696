#!/usr/bin/env python3
"""Tests place_tool recognize on painted rooms, and images unlike those of the training."""
import json
import os
import pathlib
import unittest

import cv2
from tool_case import ROOMS, ToolCase, paint
from trained_case import TrainedCase


class RecognizeTest(TrainedCase):
    def test_one_line_per_image(self):
        picture = self.write_image("now.jpg", paint("kitchen", 3, seed=2))
        path, place, confidence = self.succeed("recognize", picture, "--model",
                                               "./home.places").split()
        self.assertEqual((path, place), (str(picture), "kitchen"))
        self.assertTrue(0 <= float(confidence) <= 1)

    def test_one_object_per_line_with_all_scores(self):
        lines = self.succeed("recognize", "tuesday", "--model", "./home.places", "--json",
                             "-").splitlines()
        self.assertEqual(len(lines), 24)
        for line in lines:
            answer = json.loads(line)
            probabilities = {place: scores["probability"]
                             for place, scores in answer["scores"].items()}
            self.assertEqual(set(probabilities), set(ROOMS))
            self.assertAlmostEqual(sum(probabilities.values()), 1)
            self.assertEqual(max(probabilities, key=probabilities.get), answer["place"])
            self.assertEqual(answer["confidence"], probabilities[answer["place"]])
            self.assertEqual(answer["place"], answer["image"].split("/")[-2])
            self.assertTrue(all("margin" in scores for scores in answer["scores"].values()))
            self.assertTrue(0 <= answer["evidence"] <= 1)

    def test_unlabelled_images_and_bags_are_accepted(self):
        self.write_image("heap/1.png", paint("office", 1))
        self.write_bag("run.bag", [("corridor", None)] * 2)
        lines = self.succeed("recognize", "heap", "run.bag", "--model",
                             "./home.places").splitlines()
        self.assertEqual(["office" in lines[0], "corridor" in lines[1], "corridor" in lines[2]],
                         [True] * 3)

    def test_json_file_has_the_same_lines(self):
        on_stdout = self.succeed("recognize", "tuesday", "--model", "./home.places", "--json", "-")
        self.succeed("recognize", "tuesday", "--model", "./home.places", "--json", "answers")
        self.assertEqual((self.folder / "answers").read_text(), on_stdout)


class OtherImagesTest(TrainedCase):
    """Images unlike those that the model was trained on."""

    def write_changed(self, name, change):
        for room in ROOMS:
            for view in range(4):
                self.write_image(f"{name}/{room}/{view}.png", change(paint(room, view, 1)))

    def expect_said_once(self, run, words):
        for verb in ("evaluate", "recognize"):
            result = self.run_tool(verb, run, "--model", "./home.places")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stderr.count(words), 1, result.stderr)

    def test_another_size_is_scaled(self):
        for size in ((64, 48), (256, 192)):
            self.write_changed("other", lambda image: cv2.resize(
                image, size, interpolation=cv2.INTER_AREA if size[0] < 128 else cv2.INTER_CUBIC))
            self.expect_said_once("other", "to 128 x 96, the working size of the model")
            figures = self.figures("evaluate", "other", "--model", "./home.places")
            self.assertEqual(figures["average_rate"], 1)

    def test_another_aspect_ratio_is_said(self):
        self.write_changed("other", lambda image: image[12:84])
        self.expect_said_once("other", "another aspect ratio")

    def test_grey_is_said(self):
        self.write_changed("other", lambda image: cv2.cvtColor(image, cv2.COLOR_BGR2GRAY))
        self.expect_said_once("other", "grey")

    def test_a_camera_that_shows_nothing_is_said(self):
        self.write_changed("other", lambda image: image // 64)
        result = self.run_tool("recognize", "other", "--model", "./home.places")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr.count("Images are black"), 1, result.stderr)
        self.assertIn("nothing but one colour",
                      self.refuse("evaluate", "other", "--model", "./home.places"))
        self.write_image("other/kitchen/4.png", paint("kitchen", 4, 1))
        result = self.run_tool("evaluate", "other", "--model", "./home.places")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("12 images of a single colour", result.stderr)

    def test_frozen_frames_are_said(self):
        frozen = paint("kitchen", 0)
        for i in range(12):
            self.write_image(f"other/kitchen/{i}.png", frozen)
        self.expect_said_once("other", "the same image again and again")


class FieldSizesTest(ToolCase):
    def test_half_and_double_size(self):
        cases = pathlib.Path(os.environ.get("PLACE_RECOGNITION_TEST_DATA", "")) / "../cases"
        if not (cases / "res_half.bag").exists():
            self.skipTest("There are no bags of other sizes beside PLACE_RECOGNITION_TEST_DATA.")
        self.succeed("train", cases / "base.bag", "--model", "./base.places", "--config",
                     "crfh", "--set", "cues.crfh.feature.scales=[4, 16]")
        rates = [self.figures("evaluate", cases / f"{name}.bag", "--model",
                              "./base.places")["average_rate"]
                 for name in ("base_night", "res_half", "res_double")]
        for rate in rates[1:]:
            self.assertGreater(rate, rates[0] - 0.03)


if __name__ == "__main__":
    unittest.main()
