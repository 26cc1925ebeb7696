#!/usr/bin/env python3
"""Tests the scripts that train and test every preset on painted rooms."""
import subprocess
import unittest

from tool_case import PLACE_TOOL, SOURCE, ToolCase, paint

PRESET = ("--presets", "crfh_colour")


class ScriptsTest(ToolCase):
    def script(self, name, *arguments, place_tool=PLACE_TOOL):
        return subprocess.run([str(SOURCE / "scripts" / name), *arguments, *PRESET, "--place-tool",
                               place_tool], cwd=self.folder, text=True, env=self.environment(),
                              capture_output=True, timeout=120)

    def rows(self, name, *arguments):
        """Runs a script; returns the cells of its table below the head."""
        result = self.script(name, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [[cell.strip() for cell in line.split("|")[1:-1]]
                for line in result.stdout.splitlines()[2:]]

    def refuse(self, name, *arguments, **more):
        result = self.script(name, *arguments, **more)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        return result.stderr

    def test_presets_are_compared(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.assertEqual([row[0] for row in self.rows("compare_presets.py", "monday", "tuesday")],
                         ["`crfh_colour`"])

    def test_rooms_are_left_out_if_the_tested_run_has_them(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        for name in ("monday/__MACOSX/1.png", "tuesday/.cache/1.png", "monday/@eaDir/1.png"):
            self.write_image(name, paint("office", 0))
        whole = self.rows("leave_rooms_out.py", "monday", "tuesday")
        self.assertEqual(len(whole[0]), 8)
        for view in range(8):  # a room of monday alone
            self.write_image(f"monday/attic/{view}.png", 255 - paint("office", view))
        self.assertRegex(self.rows("leave_rooms_out.py", "monday", "tuesday")[0][2], r"^[01]\.\d+$")

    def test_what_cannot_be_used_is_told(self):
        self.write_run("monday", views=1)
        for name in ("leave_rooms_out.py", "compare_presets.py"):
            self.assertIn("/nosuch is not a program",
                          self.refuse(name, "monday", "monday", place_tool="/nosuch"))
        (self.folder / "run.bag").write_bytes(b"")
        for run in ("absent", "run.bag"):
            self.assertIn(f"{run} is not a folder", self.refuse("leave_rooms_out.py", "monday", run))


if __name__ == "__main__":
    unittest.main()
