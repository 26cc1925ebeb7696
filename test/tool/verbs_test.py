#!/usr/bin/env python3
"""Tests the other verbs of place_tool on painted rooms, as used by people and by programs."""
import json
import os
import pathlib
import unittest

import cv2
import numpy as np
from tool_case import ROOMS, ToolCase, paint

COLOUR = ("--config", "crfh_colour")


class TrainedCase(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.succeed("train", "monday", "--model", "./home.places", *COLOUR, "--set",
                     "reduction.method=none")


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


class CalibrateTest(TrainedCase):
    def test_it_fits_the_model_to_another_run_and_says_what_changed(self):
        figures = self.figures("calibrate", "tuesday", "--model", "./home.places", "--out",
                               "./calibrated.places")
        self.assertEqual(figures["images"], 24)
        evaluated = self.figures("evaluate", "tuesday", "--model", "./home.places")
        for key in ("average_rate", "calibration_error"):
            self.assertAlmostEqual(figures["before"][key], evaluated[key])
        info = self.figures("info", "./calibrated.places")
        self.assertAlmostEqual(info["unknown_threshold"], figures["after"]["unknown_threshold"])
        self.assertEqual(info["support_vectors"], evaluated["support_vectors"])
        text = self.succeed("calibrate", "tuesday", "--model", "./home.places")
        for words in ("before", "after", "calibration error", "'unknown'", "slope", "weight of"):
            self.assertIn(words, text)

    def test_it_takes_a_model_that_follows_the_light(self):
        self.succeed("train", "monday", "--model", "./default.places")
        figures = self.figures("calibrate", "tuesday", "--model", "./default.places")
        self.assertEqual(figures["images"], 24)
        self.assertGreaterEqual(figures["after"]["average_rate"], 0.9)


class EvaluateTest(TrainedCase):
    def test_figures(self):
        figures = self.figures("evaluate", "tuesday", "--model", "./home.places")
        rates = [room["rate"] for room in figures["rooms"].values()]
        self.assertAlmostEqual(figures["average_rate"], sum(rates) / len(rates))
        self.assertEqual([room["count"] for room in figures["rooms"].values()], [8, 8, 8])
        self.assertEqual(np.sum(figures["confusion"]["counts"]), 24)
        self.assertTrue(set(ROOMS) <= set(figures["confusion"]["labels"]))
        self.assertTrue(0 <= figures["calibration_error"] <= 1)
        self.assertGreater(figures["support_vectors"], 0)
        self.assertEqual(figures["model_bytes"], (self.folder / "home.places").stat().st_size)
        latency = figures["latency_ms"]
        self.assertTrue(0 < latency["p50"] <= latency["p95"] <= latency["p99"])

    def test_a_run_without_learned_rooms_has_no_rate(self):
        self.write_run("attics/attic", rooms=("kitchen",))
        (self.folder / "attics/attic/kitchen").rename(self.folder / "attics/b")
        (self.folder / "attics/attic").rmdir()
        evaluate = ("evaluate", "tuesday", "attics", "--model", "./home.places")
        runs = self.figures(*evaluate)["runs"]
        self.assertGreater(runs[0]["average_rate"], 0.5)
        self.assertIsNone(runs[1]["average_rate"])
        mean = next(line for line in self.succeed(*evaluate).splitlines() if "mean of" in line)
        self.assertEqual(mean.count("%"), 2)  # over all, and of tuesday

    def test_text_has_one_line_per_room(self):
        text = self.succeed("evaluate", "tuesday", "--model", "./home.places")
        for room in ROOMS:
            self.assertIn(room, text)

    def test_report_is_a_page(self):
        self.succeed("evaluate", "tuesday", "--model", "./home.places", "--report", "report")
        pages = list((self.folder / "report").glob("*.html"))
        self.assertEqual(len(pages), 1)
        self.assertIn("kitchen", pages[0].read_text())

    def test_evaluate_takes_a_map_of_adjoining_rooms(self):
        self.succeed("simulate", "--out", "drive", "--protocol", "drive", "--size", "64x48",
                     "--rate", 2, "--conditions", "cloudy,night")
        self.succeed("train", "drive/cloudy.bag", "--model", "./home.places", *COLOUR)
        wrong_map = self.folder / "wrong.yaml"
        wrong_map.write_text("rooms: {kitchen: [office_b], office_a: [printer_area]}")
        evaluate = ("evaluate", "drive/night.bag", "--model", "./home.places")
        learned, wrong = (self.figures(*evaluate, *adjacency) for adjacency in (
            (), ("--adjacency", "wrong.yaml")))
        self.assertEqual(learned["average_rate"], wrong["average_rate"])
        self.assertNotEqual(learned["over_time"], wrong["over_time"])
        wrong_map.write_text("rooms: {attic: [kitchen]}")
        self.assertIn("attic", self.refuse(*evaluate, "--adjacency", "wrong.yaml"))


class ReduceTest(TrainedCase):
    def reduce(self, *arguments):
        return self.figures("reduce", "--model", "./home.places", "--out", "./small.places",
                            *arguments)

    def test_figures(self):
        figures = self.reduce("--tau", 0.3)
        self.assertLess(figures["support_vectors_after"], figures["support_vectors_before"])
        self.assertTrue(0 < figures["mean_margin_change"] <= figures["max_margin_change"])
        self.assertEqual(figures["model_bytes"], (self.folder / "small.places").stat().st_size)

    def test_the_result_is_not_validated(self):
        self.assertGreater(self.figures("info", "./home.places")["validation"]["average_rate"], 0.5)
        self.reduce("--share", 0.3)
        self.assertIsNone(self.figures("info", "./small.places")["validation"])
        self.assertRegex(self.succeed("info", "./small.places"), "validation +none")

    def test_number_of_vectors(self):
        for method in ("shared-qr", "shared-greedy"):
            figures = self.reduce("--method", method, "--support-vectors", 5)
            self.assertEqual(figures["support_vectors_after"], 5, method)

    def test_training_images_as_rows_of_the_kernel_matrix(self):
        figures = self.reduce("--method", "shared-greedy", "--support-vectors", 5, "--train",
                              "monday")
        self.assertEqual(figures["support_vectors_after"], 5)

    def test_one_known_room_is_enough_to_validate_on(self):
        self.write_run("kitchens", rooms=("kitchen",), seed=1)
        figures = self.reduce("--share", 0.5, "--validate", "kitchens")
        self.assertGreater(figures["validation"]["average_rate_before"], 0.5)

    def test_loss_stays_within_bounds_and_one_vector_fewer_does_not(self):
        arguments = ("--method", "shared-qr")
        figures = self.reduce(*arguments, "--max-loss", 5, "--validate", "tuesday")
        rates = figures["validation"]
        self.assertGreaterEqual(rates["average_rate_after"], rates["average_rate_before"] - 0.05)
        evaluated = self.figures("evaluate", "tuesday", "--model", "./small.places")
        self.assertAlmostEqual(evaluated["average_rate"], rates["average_rate_after"])
        kept = figures["support_vectors_after"]
        if kept > 1:
            self.reduce(*arguments, "--support-vectors", kept - 1)
            fewer = self.figures("evaluate", "tuesday", "--model", "./small.places")
            self.assertLess(fewer["average_rate"], rates["average_rate_before"] - 0.05)


    def test_report_compares_the_methods(self):
        figures = self.reduce("--share", 0.3, "--validate", "tuesday", "--report", "report")
        self.assertEqual(set(figures["methods"]), {"qr", "shared-qr", "shared-greedy"})
        for method in figures["methods"].values():
            self.assertLessEqual(method["support_vectors"], figures["support_vectors_before"])
            self.assertEqual(method["curve"][-1][0], 1)
            self.assertGreater(method["comparison_ms"], 0)
        page = (self.folder / "report/reduction.html").read_text()
        self.assertIn("shared-greedy", page)
        self.assertIn("<svg", page)

    def test_text_names_the_images_of_the_measured_changes(self):
        arguments = ("reduce", "--model", "./home.places", "--out", "./small.places",
                     "--no-normalise")
        self.assertIn("support vectors", self.succeed(*arguments))
        self.assertIn("24 images", self.succeed(*arguments, "--train", "monday"))


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
