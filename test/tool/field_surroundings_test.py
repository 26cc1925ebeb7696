#!/usr/bin/env python3
"""Locales, home folders and scripts, and the original inputs of public reports."""
import json
import os
import pathlib
import subprocess
import unittest

from field_case import MODEL, FieldCase
from tool_case import PLACE_TOOL, ROOMS, paint


class SurroundingsTest(FieldCase):
    def train_in(self, **environment):
        result = subprocess.run(
            [PLACE_TOOL, "train", "run", *MODEL, "--json", "-"], cwd=self.folder, timeout=120,
            env={key: value for key, value in dict(self.environment(), **environment).items()
                 if value is not None}, text=True, capture_output=True)
        return result

    def test_a_locale_with_a_decimal_comma(self):
        made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8",
                               str(self.folder / "de_DE.UTF-8")], capture_output=True)
        if made.returncode > 1:
            self.skipTest("no source of the locale de_DE (package locales)")
        self.write_run("run")
        plain = self.train_in(LC_ALL="C")
        model = (self.folder / "home.places").read_bytes()
        german = self.train_in(LC_ALL="de_DE.UTF-8", LOCPATH=str(self.folder))
        figures = [json.loads(result.stdout) for result in (plain, german)]
        for figure in figures:
            figure.pop("seconds", None)
        self.assertEqual(*figures)
        self.assertTrue((self.folder / "home.places").read_bytes() == model)

    def test_no_home(self):
        self.write_run("run")
        result = self.train_in(HOME=None, ROS_HOME=None)
        self.assertEqual(result.returncode, 0, result.stderr)
        environment = {key: value for key, value in os.environ.items()
                       if key not in ("HOME", "ROS_HOME")}
        result = subprocess.run([PLACE_TOOL, "train", "run", "--model", "home"], cwd=self.folder,
                                env=environment, text=True, capture_output=True, timeout=120)
        self.assertEqual(result.returncode, 1)
        self.assert_names(result.stderr, "HOME is not set; set ROS_HOME or HOME.")

    def test_a_bag_reader_that_cannot_be_started_is_no_damage_of_the_bag(self):
        self.write_bag("run.bag", [("kitchen", "kitchen")])
        (self.folder / "bag_reader").write_text("")
        (self.folder / "bag_reader").chmod(0o755)
        self.extra_environment = {"PLACE_RECOGNITION_LIBEXEC": str(self.folder)}
        self.assertEqual(self.refuse("info", "run.bag"),
                         "place_tool info: The program bag_reader of place_recognition cannot be "
                         "started; build or install the whole package again.")

    def test_closed_streams(self):
        self.write_bag("run.bag", [("kitchen", "kitchen"), ("office", "office")] * 12)
        for closed in ("<&- >&-", ">&-", "<&- >&- 2>&-"):
            with self.subTest(closed):
                result = subprocess.run(
                    ["sh", "-c", f'"$@" {closed}', "sh", PLACE_TOOL, "train", "run.bag", *MODEL],
                    cwd=self.folder, env=self.environment(), text=True, capture_output=True,
                    timeout=120)
                said = self.without_progress(result.stderr)
                self.assertEqual(said, [] if "2" in closed else [
                    "place_tool train: cannot write to the standard output; make room, or redirect it."])
                self.assertIn("office", self.succeed("info", "./home.places"))
                (self.folder / "home.places").unlink()

    def test_names_in_any_script(self):
        names = ["\U0001f373 kitchen", "\U0001f469\u200d\U0001f373", "\u5eca\u4e0b", "\u063a\u0631\u0641\u0629"]
        for i, name in enumerate(names):
            for view in range(8):
                self.write_image(f"\u2615 run/{name}/{view}.png",
                                   paint(list(ROOMS)[i % 3], 8 * i + view, seed=i))
        self.assertEqual(self.rooms_of("\u2615 run"), sorted(names))
        figures = self.figures("evaluate", "\u2615 run", "--model", "./home.places", "--report",
                               "report \u2615")
        self.assertEqual(sorted(figures["confusion"]["labels"]), sorted(names))
        self.succeed("import", "\u2615 run", "--out", "\u2615.bag")
        self.assertEqual(self.rooms_of("\u2615.bag"), sorted(names))
        for name in names:
            self.assertIn(name, self.succeed("info", "./home.places"))


class SharedCasesTest(FieldCase):
    """The original inputs of the reports, if the folder exists."""

    def setUp(self):
        super().setUp()
        self.cases = pathlib.Path(os.environ.get("PLACE_RECOGNITION_TEST_DATA", "")).parent / "cases"
        if not self.cases.is_dir():
            self.skipTest(f"no {self.cases}")

    def test_rooms(self):
        three = ["corridor", "kitchen", "office_a"]
        for case in ("base.bag", "csvlabels/run.bag", "bom/run.bag", "header/run.bag",
                     "noslash/run.bag", "trunc/run.bag", "mac/run", "mac/parent",
                     "zerotime/run.bag", "rgbjpg/compressed.bag", "cdepth.bag"):
            with self.subTest(case):
                figures, said = self.train(self.cases / case)
                self.assertEqual(sorted(figures["rooms"]), three)
                if case == "trunc/run.bag":
                    self.assertEqual((figures["images"], figures["skipped_images"]), (48, 24))
                elif case not in ("zerotime/run.bag",):
                    self.assertEqual(figures["skipped_images"], 0, said)

    def test_five_rooms_of_several_formats(self):
        figures, said = self.train(self.cases / "webp/run")
        self.assertEqual(len(figures["rooms"]), 5, said)

    def test_trailing_blanks(self):
        figures, said = self.train(self.cases / "trailing.bag", self.cases / "base.bag")
        self.assertEqual(sorted(figures["rooms"]), ["Office_A", "corridor", "kitchen", "office_a"])
        self.assertIn("differ only in upper and lower case", said)

    def test_split(self):
        figures, said = self.train(self.cases / "split/run_0.bag", self.cases / "split/run_1.bag")
        self.assertEqual(figures["skipped_images"], 0, said)

    def test_an_empty_frame(self):
        self.train(self.cases / "base.bag")
        result = self.run_tool("recognize", self.cases / "emptyframe.bag", *MODEL[:2])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("1 image cannot be used", result.stderr)


if __name__ == "__main__":
    unittest.main()
