#!/usr/bin/env python3
"""Tests place_tool tune on painted rooms."""
import json
import signal
import subprocess
import time
import unittest

from tool_case import PLACE_TOOL, ToolCase

SMALL_SPACE = """
descriptors: [[R, G, B], [Lxx, Lyy], [L]]
scales: [[1], [4]]
bins: [6, 12]
first_pictures: 12
"""


class TuneTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("monday")
        (self.folder / "space.yaml").write_text(SMALL_SPACE)

    def test_its_configuration_trains_a_model_and_lists_what_was_tried(self):
        figures = self.figures("tune", "monday", "--space", "space.yaml", "--out", "office.yaml")
        text = (self.folder / "office.yaml").read_text()
        self.assertTrue(figures["complete"])
        self.assertEqual(figures["pictures"], 24)
        for trial in figures["trials"]:
            for cue in trial["cues"]:
                self.assertIn(cue["name"], text)
        self.assertGreaterEqual(figures["best"]["rate"], 0.9)
        self.succeed("train", "monday", "--model", "./office.places", "--config", "office.yaml")

    def test_it_tells_how_many_images_it_used(self):
        (self.folder / "space.yaml").write_text(SMALL_SPACE + "max_pictures: 12\n")
        said = self.succeed("tune", "monday", "--space", "space.yaml", "--out", "office.yaml")
        self.assertIn(" configurations tried on at most 12 of 24 images in ", said)

    def test_same_runs_give_the_same_configuration(self):
        for name, threads in (("a", 1), ("b", 2)):
            self.succeed("tune", "monday", "--space", "space.yaml", "--out", f"{name}.yaml",
                         "--threads", threads)
        self.assertEqual((self.folder / "a.yaml").read_bytes(),
                         (self.folder / "b.yaml").read_bytes())

    def test_runs_may_be_held_out(self):
        self.write_run("tuesday", seed=1)
        figures = self.figures("tune", "monday", "--validate", "tuesday", "--space", "space.yaml",
                               "--out", "office.yaml")
        self.assertEqual(figures["pictures"], 48)

    def test_cues_of_a_configuration_are_tried_too(self):
        (self.folder / "lbp.yaml").write_text("cues: [{name: patterns, feature: {type: lbp}}]")
        figures = self.figures("tune", "monday", "--space", "space.yaml", "--config", "lbp.yaml",
                               "--out", "office.yaml")
        self.assertIn("patterns", {cue["name"] for trial in figures["trials"]
                                   for cue in trial["cues"]})

    def test_a_stop_keeps_the_best_so_far(self):
        self.write_run("long", views=60)
        process = subprocess.Popen(
            [PLACE_TOOL, "tune", "long", "--out", "office.yaml", "--progress", "json"],
            cwd=self.folder, env=self.environment(), text=True, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        for line in process.stdout:
            progress = json.loads(line)
            if progress["stage"].startswith("Looking") and progress["fraction"] > 0.3:
                process.send_signal(signal.SIGINT)
                break
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("stopped before its end", (self.folder / "office.yaml").read_text())
        self.succeed("train", "long", "--model", "./office.places", "--config", "office.yaml")

    def test_a_stop_before_the_first_result_keeps_what_is_there(self):
        self.write_run("long", views=60)
        (self.folder / "office.yaml").write_text("svm: {c: 7}")
        process = subprocess.Popen(
            [PLACE_TOOL, "tune", "long", "--out", "office.yaml", "--progress", "json"],
            cwd=self.folder, env=self.environment(), text=True, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        for line in process.stdout:
            if json.loads(line)["stage"].startswith("Looking for cues"):
                process.send_signal(signal.SIGINT)
                break
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual((self.folder / "office.yaml").read_text(), "svm: {c: 7}")

    def test_parts_and_a_killed_search_give_the_same_configuration(self):
        self.write_run("long", views=40)
        search = ("tune", "long", "--space", "space.yaml", "--out")
        self.succeed(*search, "whole.yaml")
        for part, cells in ((3, 2), (1, 2), (2, 1)):  # a round leaves one cue of Lxx Lyy's four
            figures = self.figures(*search, "parts.yaml", "--cells", "a", "--part", f"{part}/3")
            self.assertEqual(figures, {"cells": cells, "computed": cells})
            self.assertFalse((self.folder / "parts.yaml").exists())
        self.succeed(*search, "parts.yaml", "--cells", "a")
        self.assertEqual(len(list((self.folder / "a").iterdir())), 5)

        process = subprocess.Popen([PLACE_TOOL, *search, "killed.yaml", "--cells", "b"],
                                   cwd=self.folder, env=self.environment(),
                                   stderr=subprocess.DEVNULL)
        while not list(self.folder.glob("b/*.json")):
            self.assertIsNone(process.poll())
            time.sleep(0.001)
        process.kill()
        process.wait()
        kept = {path: path.stat().st_mtime_ns for path in self.folder.glob("b/*.json")}
        self.assertLess(len(kept), 5)
        self.assertFalse((self.folder / "killed.yaml").exists())
        self.succeed(*search, "killed.yaml", "--cells", "b")
        for path, time_of_change in kept.items():
            self.assertEqual(path.stat().st_mtime_ns, time_of_change)
        for name in ("parts", "killed"):
            self.assertEqual((self.folder / f"{name}.yaml").read_bytes(),
                             (self.folder / "whole.yaml").read_bytes())

    def test_a_part_needs_a_place_for_its_cells(self):
        self.assertIn("--cells", self.refuse("tune", "monday", "--out", "o.yaml", "--part", "1/2",
                                             status=2))
        self.assertIn("3/2", self.refuse("tune", "monday", "--out", "o.yaml", "--cells", "cells",
                                         "--part", "3/2", status=2))

    def test_bad_spaces_are_refused(self):
        for text, word in (("bins: []", "bins"), ("colour: [1]", "colour"),
                           ("c: [0]", "'c'"), ("descriptors: [[Q]]", "Q")):
            (self.folder / "bad.yaml").write_text(text)
            message = self.refuse("tune", "monday", "--space", "bad.yaml", "--out", "o.yaml")
            self.assertIn(word, message)


if __name__ == "__main__":
    unittest.main()
