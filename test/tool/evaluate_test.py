#!/usr/bin/env python3
"""Tests place_tool evaluate and calibrate on painted rooms."""
import unittest

import numpy as np
from tool_case import ROOMS
from trained_case import COLOUR, TrainedCase


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
        for words in ("before", "after", "calibration error", "'unknown'", "slope", "weight of",
                      "is set for 5"):
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


if __name__ == "__main__":
    unittest.main()
