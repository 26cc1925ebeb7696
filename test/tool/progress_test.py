#!/usr/bin/env python3
"""Progress for terminals, logs and programs, and the files that a stopped program leaves."""
import json
import os
import pty
import signal
import subprocess
import time
import unittest

from tool_case import PLACE_TOOL, ToolCase

SIMULATE = ("simulate", "--out", "runs", "--conditions", "night", "--size", "32x24")


class ProgressTest(ToolCase):
    def test_json_lines_come_before_the_result_which_is_last(self):
        self.write_run("monday")
        lines = [json.loads(line) for line in self.succeed(
            "train", "monday", "--model", "./m.places", "--progress", "json", "--json",
            "-").splitlines()]
        self.assertEqual(lines[-1]["images"], 24)
        self.assertGreater(len(lines), 2)
        for line in lines[:-1]:
            self.assertEqual(set(line), {"stage", "fraction"})
            self.assertTrue(0 <= line["fraction"] <= 1)

    def test_json_lines_of_a_run_whose_name_is_not_utf8(self):
        path = os.fsencode(self.folder) + b"/caf\xe9"
        os.rename(self.folder / self.write_run("monday"), path)
        lines = [json.loads(line) for line in self.succeed(
            "train", os.fsdecode(path), "--model", "./m.places", "--progress",
            "json").splitlines()]
        self.assertTrue(any("caf\ufffd" in line["stage"] for line in lines), lines)

    def test_text_for_people_leaves_stdout_to_the_json_lines(self):
        self.write_run("monday")
        self.succeed("train", "monday", "--model", "./m.places")
        result = self.run_tool("info", "./m.places", "--progress", "json")
        self.assertEqual(result.stdout, "")
        self.assertIn("kitchen", result.stderr)

    def test_lines_on_stderr_where_there_is_no_terminal(self):
        tool = subprocess.Popen([PLACE_TOOL, "simulate", "--out", "runs"], cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.assertRegex(tool.stderr.readline(), r"^Rendering .*: \d+ %")
        tool.terminate()
        tool.communicate(timeout=60)

    def test_bar_on_a_terminal_disappears_at_the_end(self):
        terminal, tool_side = pty.openpty()
        tool = subprocess.Popen([PLACE_TOOL, *SIMULATE], cwd=self.folder, stderr=tool_side,
                                stdout=subprocess.DEVNULL)
        os.close(tool_side)
        shown = b""
        try:
            while chunk := os.read(terminal, 65536):
                shown += chunk
        except OSError:  # the other end is closed
            pass
        self.assertEqual(tool.wait(), 0)
        self.assertIn(b"#", shown)
        self.assertTrue(shown.endswith(b"\r\x1b[K"))

    def test_none(self):
        self.assertEqual(self.run_tool(*SIMULATE, "--progress", "none").stderr, "")


class StopTest(ToolCase):
    def stop(self, number, *arguments):
        """Starts the tool and signals it at its first progress output. Returns its last line."""
        tool = subprocess.Popen([PLACE_TOOL, *arguments, "--progress", "json"], cwd=self.folder,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        tool.stdout.readline()
        tool.send_signal(number)
        _, errors = tool.communicate(timeout=60)
        self.assertEqual(tool.returncode, 130)
        return errors

    def test_nothing_half_written_is_left(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for form in ("bag", "images"):
                errors = self.stop(number, "simulate", "--out", "runs", "--format", form,
                                   "--size", "64x48")
                self.assertEqual(errors, "place_tool simulate: stopped.\n")
                self.assertEqual(self.files(), [])

    def test_the_end_of_the_bag_reader_is_not_reported_as_damage(self):
        """Ctrl-C in a terminal reaches all programs of the job."""
        self.write_bag("run.bag", [("kitchen", "kitchen"), ("office", "office")] * 100)
        for wait in (0, .03, .1, .3):
            tool = subprocess.Popen(
                [PLACE_TOOL, "train", *["run.bag"] * 10, "--model", "./m.places", "--progress", "json"],
                cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                start_new_session=True)
            tool.stdout.readline()
            time.sleep(wait)
            os.killpg(tool.pid, signal.SIGINT)
            said = tool.communicate(timeout=60)[1]
            self.assertEqual((tool.returncode, said.splitlines()[-1]), (130, "place_tool train: stopped."))

    def test_training_writes_no_model(self):
        self.write_run("monday")
        before = self.files()
        self.assertIn("stopped", self.stop(signal.SIGTERM, "train", "monday", "--model", "./m.places"))
        self.assertEqual(self.files(), before)


if __name__ == "__main__":
    unittest.main()
