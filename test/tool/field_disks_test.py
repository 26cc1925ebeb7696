#!/usr/bin/env python3
"""Disks that are full, and devices."""
import pathlib
import resource
import subprocess
import unittest

from field_case import MODEL, FieldCase
from tool_case import PLACE_TOOL


class FullDiskTest(FieldCase):
    """A limit on the size of files stands for a disk that is full: the kernel refuses to write."""

    def refuse_within(self, kilobytes, *arguments):
        before = self.files()
        limit = kilobytes * 1024
        result = subprocess.run(
            [PLACE_TOOL, *arguments], cwd=self.folder, text=True, capture_output=True, timeout=120,
            env=self.environment(),
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(result.returncode, 1, result.stderr)
        lines = [line for line in result.stderr.splitlines() if not line.endswith(" %")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assert_names(lines[0], "Cannot write", "make room")
        self.assertEqual(self.files(), before)

    def test_every_writer_of_bags_and_pictures(self):
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
