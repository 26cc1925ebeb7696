#!/usr/bin/env python3
"""Tests place_tool reduce on painted rooms."""
import json
import shutil
import unittest

from trained_case import COLOUR, TrainedCase


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

    def test_report_compares_methods_of_the_model_that_it_replaces(self):
        shutil.copy(self.folder / "home.places", self.folder / "same.places")
        other = self.reduce("--share", 0.3, "--report", "report")
        same = self.figures("reduce", "--model", "./same.places", "--out", "./same.places",
                            "--share", 0.3, "--report", "report")
        for method, figures in other["methods"].items():
            for key in ("support_vectors", "max_margin_change", "model_bytes"):
                self.assertEqual(same["methods"][method][key], figures[key], method)

    def test_text_names_the_images_of_the_measured_changes(self):
        arguments = ("reduce", "--model", "./home.places", "--out", "./small.places",
                     "--no-normalize")
        self.assertIn("support vectors", self.succeed(*arguments))
        self.assertIn("24 images", self.succeed(*arguments, "--train", "monday"))

    def test_a_run_that_the_model_learned_is_no_judge(self):
        self.assertIn("./home.places was trained on monday; give another run",
                      self.refuse("reduce", "--model", "./home.places", "--out", "./small.places",
                                  "--share", 0.5, "--validate", "tuesday", "monday"))

    def test_it_warns_if_the_images_to_preserve_are_those_of_another_run(self):
        reduce = ("reduce", "--model", "./home.places", "--out", "./small.places", "--train")
        result = self.run_tool(*reduce, "tuesday", "--json", "-")
        sentence = "./home.places was not trained on tuesday; give the runs that it was trained on."
        self.assertIn("warning: --train: " + sentence, result.stderr)
        self.assertTrue(any(sentence in text for text in json.loads(result.stdout)["warnings"]))
        self.assertNotIn("not trained on", self.run_tool(*reduce, "monday").stderr)

    def test_it_names_what_it_left_out_of_the_runs(self):
        for run in ("monday", "tuesday"):
            (self.folder / run / "kitchen/000.png").write_bytes(b"rubbish")
        result = self.run_tool("reduce", "--model", "./home.places", "--out", "./small.places",
                               "--train", "monday", "--validate", "tuesday", "--json", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        warnings = json.loads(result.stdout)["warnings"]
        for run in ("monday", "tuesday"):
            self.assertIn(f"warning: {run}: 1 image", result.stderr)
            self.assertTrue(any(run in warning for warning in warnings), warnings)

    def test_it_is_judged_by_the_images_as_recorded(self):
        self.succeed("train", "monday", "--model", "./home.places", *COLOUR, "--set",
                     "augmentation.other_light=true")
        figures = self.reduce("--support-vectors", 2, "--validate", "tuesday")
        evaluated = self.figures("evaluate", "tuesday", "--model", "./small.places")
        self.assertAlmostEqual(figures["validation"]["average_rate_after"],
                               evaluated["average_rate"])


if __name__ == "__main__":
    unittest.main()
