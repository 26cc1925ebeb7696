#!/usr/bin/env python3
"""Full disks, and devices."""
import json
import os
import pathlib
import resource
import subprocess
import unittest

from field_case import MODEL, FieldCase
from tool_case import PLACE_TOOL


class FullDiskTest(FieldCase):
    """Simulates a full disk by a limit on the size of files: the kernel refuses to write more."""

    def refuse_within(self, kilobytes, *arguments):
        before = self.files()
        limit = kilobytes * 1024
        result = subprocess.run(
            [PLACE_TOOL, *arguments], cwd=self.folder, text=True, capture_output=True, timeout=120,
            env=self.environment(),
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(result.returncode, 1, result.stderr)
        lines = self.without_progress(result.stderr)
        self.assertEqual(len(lines), 1, result.stderr)
        self.assert_names(lines[0], "Cannot write", "make room")
        self.assertEqual(self.files(), before)

    def test_created_folders_are_removed_with_their_contents(self):
        self.write_run("run")
        self.write_run("light/cloudy")
        self.write_run("light/night", seed=1)
        self.succeed("train", "light/night", *MODEL)
        self.refuse_within(0, "simulate", "--out", "new/runs", "--size", "96x72", "--conditions",
                           "night")
        self.refuse_within(1, "evaluate", "run", *MODEL[:2], "--report", "new/report")
        self.refuse_within(0, "experiment", "indecs-global", "--data", "light", "--every", "4",
                           "--out", "new/tables")

    def test_every_writer_of_bags_and_images(self):
        self.write_run("run", views=12)
        (self.folder / "out").mkdir()
        for kilobytes in (0, 1, 8, 40):
            self.refuse_within(kilobytes, "import", "run", "--out", "run.bag")
            self.refuse_within(kilobytes, "import", "run", "--out", "run.bag", "--raw")
        simulate = ("simulate", "--out", "out", "--size", "96x72", "--conditions", "night")
        self.refuse_within(8, *simulate)
        self.refuse_within(1, *simulate, "--format", "images")

    def test_every_writer_of_other_files(self):
        self.write_run("run")
        self.refuse_within(1, "train", "run", *MODEL)
        self.succeed("train", "run", *MODEL)
        self.refuse_within(0, "recognize", "run", *MODEL[:2], "--json", "answers")

    def test_standard_output(self):
        self.write_run("run")
        self.succeed("train", "run", *MODEL)
        for arguments in (("recognize", "run", *MODEL[:2]), ("info", "./home.places"),
                          ("info", "./home.places", "--json", "-")):
            with open("/dev/full", "w") as full:
                result = subprocess.run([PLACE_TOOL, *arguments], cwd=self.folder, text=True,
                                        stdout=full, stderr=subprocess.PIPE, timeout=120,
                                        env=self.environment())
            self.assertEqual(result.returncode, 1, arguments)
            self.assert_names(result.stderr, "standard output")

    def test_links_stay_and_their_targets_are_written(self):
        self.write_run("run")
        store = self.folder / "store"
        store.mkdir()
        for name in ("answers", "home.places", "run.bag", "new"):
            (self.folder / name).symlink_to(store / name)
        self.succeed("train", "run", *MODEL)
        first = (store / "home.places").read_bytes()
        self.succeed("train", "run", *MODEL, "--set", "svm.c=1")
        self.assertTrue((self.folder / "home.places.1").read_bytes() == first)
        self.assertFalse((store / "home.places").read_bytes() == first)
        self.succeed("recognize", "run", *MODEL[:2], "--json", "answers")
        self.succeed("import", "run", "--out", "run.bag")
        for name in ("answers", "home.places", "run.bag"):
            self.assertTrue((self.folder / name).is_symlink(), name)
            self.assertGreater((store / name).stat().st_size, 1000)
        self.succeed("restore", "./home.places")
        self.assertTrue((store / "home.places").read_bytes() == first)

    @unittest.skipUnless(os.geteuid() == 0, "to become somebody without rights")
    def test_the_standard_output_by_its_name(self):
        self.write_run("run")
        self.succeed("train", "run", *MODEL)
        for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
            with self.subTest(name), open(self.folder / "out", "w+") as out:
                os.chmod(self.folder / "out", 0o666)
                result = self.run_as_nobody("info", MODEL[1], "--json", name, stdout=out)
                self.assertEqual(result.returncode, 0, result.stderr)
                out.seek(0)
                text = out.read()
                self.assertIn("rooms", json.loads(text.splitlines()[-1]))

    @unittest.skipUnless(os.geteuid() == 0, "to become somebody without rights")
    def test_what_cannot_be_written_is_told_before_the_work(self):
        self.write_run("run")
        self.succeed("train", "run", *MODEL)
        (self.folder / "locked").mkdir(mode=0o555)
        (self.folder / "folder").mkdir()
        (self.folder / "file").touch()
        for target, words in (("locked/x", "locked: Permission denied"), ("folder", "is a folder"),
                              ("file/x", "file is not a folder")):
            for verb in (("train", "run", "--model", f"./{target}"),
                         ("train", "run", *MODEL, "--json", target),
                         ("evaluate", "run", *MODEL[:2], "--json", target),
                         ("calibrate", "run", *MODEL[:2], "--out", f"./{target}"),
                         ("import", "run", "--out", target)):
                with self.subTest(verb):
                    result = self.run_as_nobody(*verb, "--progress", "lines")
                    self.assertEqual(result.returncode, 1)
                    self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                    self.assert_names(result.stderr, "Cannot write", target, words)

    def test_an_empty_value_is_bad_usage(self):
        self.write_run("run")
        for option in ("--json", "--model", "--label", "--config", "--set"):
            model = () if option == "--model" else MODEL[:2]
            line = self.refuse("train", "run", *model, option, "", status=2)
            self.assert_names(line, option, "is empty")
        self.assert_names(self.refuse("train", "", *MODEL, status=2), "INPUT", "is empty")
        self.assert_names(self.refuse("import", "run", "--out", "", status=2), "is empty")

    def test_devices_are_written_to_and_stay(self):
        self.write_run("run")
        self.succeed("train", "run", *MODEL)
        line = self.run_tool("recognize", "run", *MODEL[:2], "--json", "/dev/full").stderr
        self.assert_names(line, "Cannot write /dev/full")
        self.assertTrue(pathlib.Path("/dev/full").is_char_device())
        self.succeed("recognize", "run", *MODEL[:2], "--json", "/dev/null")
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())
        self.refuse("import", "run", "--out", "/dev/full")


if __name__ == "__main__":
    unittest.main()
