#!/usr/bin/env python3
"""Tests when place_tool label ends: with its page, or with Ctrl-C. Separate from its other tests,
because these depend on real time and must not run on a busy machine."""
import subprocess
import time
import unittest

from label_case import LabelCase, span
from tool_case import PLACE_TOOL


class EndTest(LabelCase):
    def setUp(self):
        super().setUp()
        self.record("run.bag")
        self.served = self.page("run.bag")

    def test_it_ends_with_the_page(self):
        events = self.served.open_events()
        events.close()
        self.served.process.wait(timeout=30)
        self.assertEqual(self.served.stop(), (0, "The page was closed.\n"))

    def test_it_waits_while_the_page_is_loaded_again(self):
        events = self.served.open_events()
        events.close()
        again = self.served.open_events()
        time.sleep(5)
        self.assertIsNone(self.served.process.poll())
        again.close()

    def test_a_page_that_is_lost_may_come_back_for_its_changes(self):
        events = self.served.open_events()
        spans = [span(0, 1, "kitchen")]
        self.served.post("draft", {"spans": spans})
        events.close()
        time.sleep(5)
        recording = self.served.get("recording")
        self.assertEqual((recording["spans"], recording["unsaved"]), (spans, True))
        events = self.served.open_events()
        self.served.post("goodbye", {})
        events.close()
        self.served.process.wait(timeout=30)
        self.assertIn("not saved", self.served.stop()[1])

    def test_it_ends_with_control_c(self):
        self.served.open_events()
        status, said = self.served.stop()
        self.assertEqual((status, said), (0, ""))

    def test_it_tells_how_to_reach_it_without_a_display(self):
        environment = self.environment()
        environment.pop("DISPLAY", None)
        environment.pop("WAYLAND_DISPLAY", None)
        process = subprocess.Popen([PLACE_TOOL, "label", "run.bag"], cwd=self.folder, text=True,
                                   env=environment, stdout=subprocess.PIPE)
        lines = [process.stdout.readline(), process.stdout.readline()]
        process.terminate()
        process.communicate(timeout=30)
        self.assertIn("http://127.0.0.1:", lines[0])
        self.assertIn("ssh -L", lines[1])


if __name__ == "__main__":
    unittest.main()
