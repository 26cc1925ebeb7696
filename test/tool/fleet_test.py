#!/usr/bin/env python3
"""experiments/fleet.smk on painted buildings, and the report on all of them."""
import json
import os
import shutil
import subprocess
import sys
import unittest

from tool_case import PLACE_TOOL, SOURCE, ToolCase


def training(images=40, warnings=()):
    return {"images": images, "rooms": {"hall": {"count": 20}, "lab": {"count": 20}},
            "support_vectors": 12, "model_bytes": 2048, "warnings": list(warnings),
            "validation": {"average_rate": 0.975, "calibration_error": 0.01,
                           "rooms": ["hall", "lab"]}}


def evaluation(rate):
    return {"average_rate": rate, "calibration_error": 0.125, "unknown_share": 0.05,
            "rooms": {"hall": {"rate": 1.0, "count": 9}, "lab": {"rate": 2 * rate - 1, "count": 9}},
            "warnings": []}


class ReportTest(ToolCase):
    def write(self, name, content):
        path = self.folder / "out" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(content))

    def report(self, **environment):
        result = subprocess.run([sys.executable, str(SOURCE / "experiments/fleet_report.py"), "out"],
                                cwd=self.folder, capture_output=True, text=True, check=False,
                                env=dict(os.environ, **environment))
        self.assertEqual(result.returncode, 0, result.stderr)
        return [(self.folder / "out" / name).read_text(encoding="utf-8")
                for name in ("report.md", "report.html")]

    def test_the_worst_building_comes_first_and_one_without_a_test_last(self):
        self.write("annex/training.json", training())
        self.write("good/training.json", training())
        self.write("good/evaluation.json", evaluation(0.95))
        self.write("poor/training.json", training())
        self.write("poor/evaluation.json", evaluation(0.75))
        markdown, page = self.report()
        rows = markdown.splitlines()[2:]
        self.assertEqual(rows[0], "| poor | 2 | 40 | 12 | 2 | 97.5 % | 75.0 % | 0.125 | 5.0 % | "
                                  "lab (50.0 %) |")
        self.assertEqual([row.split(" | ")[0] for row in rows], ["| poor", "| good", "| annex"])
        self.assertIn('<a href="poor/report/report.html">poor</a>', page)
        self.assertNotIn("annex/report", page)

    def test_names_and_warnings_are_shown_as_they_are(self):
        self.write("B & <C>/training.json", training(warnings=["'a' and <b> look alike"]))
        markdown, page = self.report()
        self.assertIn("- 'a' and <b> look alike", markdown)
        self.assertIn("B &amp; &lt;C&gt;", page)
        self.assertIn("&#x27;a&#x27; and &lt;b&gt; look alike", page)

    def test_names_in_a_locale_without_utf_8(self):
        self.write("K\u00fcche/training.json", training(warnings=["\u5eca\u4e0b"]))
        for text in self.report(LC_ALL="POSIX", PYTHONCOERCECLOCALE="0", PYTHONUTF8="0"):
            self.assertIn("K\u00fcche", text)
            self.assertIn("\u5eca\u4e0b", text)


@unittest.skipUnless(shutil.which("snakemake"), "snakemake is not installed")
class WorkflowTest(ToolCase):
    def run_workflow(self, *options, **config):
        settings = {"buildings": "site", "out": "fleet", "tool": PLACE_TOOL, **config}
        return subprocess.run(
            ["snakemake", "-s", str(SOURCE / "experiments/fleet.smk"), "--cores", "2", *options,
             "--config", *(f"{key}={value}" for key, value in settings.items())],
            cwd=self.folder, env=self.environment(), capture_output=True, text=True, timeout=300,
            check=False)

    def test_each_building_gets_the_model_that_train_makes(self):
        for seed, name in enumerate(("north wing", "south")):
            self.write_run(f"site/{name}/train/monday", seed=seed)
        self.write_run("site/south/test/tuesday", seed=7)
        result = self.run_workflow(options="--config crfh")
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in ("north wing", "south"):
            self.run_tool("train", f"site/{name}/train", "--model", f"by_hand/{name}.places",
                          "--config", "crfh")
            self.assertEqual((self.folder / f"fleet/models/{name}.places").read_bytes(),
                             (self.folder / f"by_hand/{name}.places").read_bytes())
        report = (self.folder / "fleet/report.md").read_text()
        self.assertIn("| south | 3 | 24 |", report)
        self.assertTrue((self.folder / "fleet/south/report/report.html").is_file())
        self.assertIn("Nothing to be done", self.run_workflow(options="--config crfh").stderr)

    def test_parts_of_a_search_find_what_tune_finds(self):
        self.write_run("site/north wing/train/monday")
        (self.folder / "space.yaml").write_text(
            "{descriptors: [[R, G, B], [Lxx, Lyy], [L]], scales: [[1], [4]], bins: [6, 12]}")
        settings = {"tune": 1, "parts": 2, "search": "--space space.yaml"}
        result = self.run_workflow(**settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.run_tool("tune", "site/north wing/train", "--space", "space.yaml", "--out",
                      "by_hand.yaml")
        tuned = self.folder / "fleet/north wing/tuned.yaml"
        self.assertEqual(tuned.read_bytes(), (self.folder / "by_hand.yaml").read_bytes())

        cells = sorted((self.folder / "fleet/north wing/search/cells").iterdir())
        self.assertEqual(len(cells), 3)
        cells[0].unlink()
        for lost in ("north wing/search/1", "north wing/tuned.yaml", "north wing/training.json",
                     "report.html"):
            (self.folder / "fleet" / lost).unlink()
        times = [cell.stat().st_mtime_ns for cell in cells[1:]]
        result = self.run_workflow(**settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(tuned.read_bytes(), (self.folder / "by_hand.yaml").read_bytes())
        self.assertEqual([cell.stat().st_mtime_ns for cell in cells[1:]], times)
        self.assertTrue(cells[0].exists())

    def test_a_folder_without_buildings_is_refused(self):
        (self.folder / "site").mkdir()
        result = self.run_workflow()
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("site contains no BUILDING/train folder", result.stderr + result.stdout)


if __name__ == "__main__":
    unittest.main()
