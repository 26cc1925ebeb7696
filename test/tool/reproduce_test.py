#!/usr/bin/env python3
"""Tests scripts/reproduce on painted rooms that are named as in the published data sets."""
import os
import subprocess
import unittest

from tool_case import PLACE_TOOL, ROOMS, SOURCE, ToolCase, paint

CONDITIONS = ("cloudy", "night", "sunny")
IDOL_CODES = {"kitchen": "KT", "corridor": "CR", "office": "EO"}


class ReproduceTest(ToolCase):
    def reproduce(self, *arguments):
        return subprocess.run([str(SOURCE / "scripts/reproduce"), *arguments, "--place-tool",
                               PLACE_TOOL], cwd=self.folder, text=True, env=self.environment(),
                              capture_output=True, timeout=120)

    def report(self, layout, experiments):
        result = self.reproduce(layout, "data", "--out", "out", "--experiments", experiments)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "out/report.md\n")
        return (self.folder / "out/report.md").read_text()

    def test_indecs(self):
        for seed, condition in enumerate(CONDITIONS):
            for room in ROOMS:
                for view in range(4):
                    self.write_image(f"data/{condition}/{room}/{room}_01_{30 * view:03d}.png",
                                       paint(room, view, seed))
        report = self.report("indecs", "indecs-global,learning-curve")
        for condition in CONDITIONS:
            self.assertIn(f"| {condition} | 12 | corridor, kitchen, office |", report)
            self.assertTrue((self.folder / f"out/bags/{condition}.bag").is_file())
        for title in ("Table 8.6", "Table 8.1", "images per room", "viewpoint", "Total time"):
            self.assertIn(title, report)

    def test_indecs_without_one_of_the_lights(self):
        for seed, condition in enumerate(("Cloudy", "night")):
            for room in ROOMS:
                for view in range(3):
                    self.write_image(f"data/{room}_{condition}_01_{30 * view:03d}.png",
                                       paint(room, view, seed))
        report = self.report("indecs", "indecs-global")
        self.assertIn("| night | 9 |", report)
        self.assertNotIn("sunny |", report.split("## indecs-global")[0])

    def test_names_in_a_locale_without_utf_8(self):
        for view in range(2):
            for condition in CONDITIONS[:2]:
                self.write_image(f"data/{condition}/K\u00fcche_{view:03d}.png",
                                 paint("kitchen", view))
        self.extra_environment = {"LC_ALL": "POSIX", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
        result = self.reproduce("indecs", "data", "--out", "out", "--experiments", "bins")
        self.assertNotIn("Error", result.stderr)
        self.assertIn("| K\u00fcche |",
                      (self.folder / "out/report.md").read_text(encoding="utf-8"))

    def test_idol(self):
        for seed, sequence in enumerate(("dum_cloudy1", "dum_night2", "min_sunny1")):
            for i, room in enumerate(sorted(ROOMS) * 3):
                self.write_image(f"data/{sequence}/t11254962{seed}{i}.5_r{IDOL_CODES[room]}_x1.0"
                                   f"_y-2.0_a0.5.png", paint(room, i, seed))
        self.assertIn("| min_sunny1 | 9 | CR, EO, KT |", self.report("idol", "indecs-global"))

    def test_cold_has_categories(self):
        rooms = sorted(ROOMS)
        for seed, laboratory in enumerate(("freiburg", "ljubljana", "saarbruecken")):
            for sequence, light in enumerate(("cloudy", "sunny")):
                folder = f"data/{laboratory}/seq1_{light}1"
                lines = []
                for i in range(9):
                    name = f"t115288649{i}.25_x0.2_y0.0_a0.1.jpeg"
                    self.write_image(f"{folder}/std_cam/{name}",
                                       paint(rooms[i // 3], i, 2 * seed + sequence))
                    lines.append(f"{name} {rooms[i // 3]}{seed + 1}-A\n")
                places = self.folder / folder / "localization/places.lst"
                places.parent.mkdir()
                places.write_text("".join(lines))
        report = self.report("cold", "categories")
        self.assertIn("| ljubljana_seq1_sunny1 | 9 | corridor2-A, kitchen2-A, office2-A |", report)
        rows = [line.split() for line in report.splitlines()]
        self.assertEqual(rows.count(["place", "freiburg", "ljubljana", "saarbruecken"]), 2)
        for room in rooms:  # corridor1-A, corridor2-A and corridor3-A are of one kind
            self.assertEqual(len([row for row in rows if row[:1] == [room]]), 2, report)

    def test_what_fails_is_in_the_report(self):
        os.makedirs(self.folder / "data/cloudy")
        result = self.reproduce("indecs", "data", "--out", "out", "--experiments", "bins")
        self.assertEqual(result.returncode, 1)
        self.assertIn("`place_tool experiment bins` failed",
                      (self.folder / "out/report.md").read_text())
        self.assertEqual(self.reproduce("idol", "data", "--out", "out", "--experiments",
                                        "categories").returncode, 2)
        result = self.reproduce("indecs", "data", "--out", "/proc/nowhere")
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("reproduce: /proc/nowhere", result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
