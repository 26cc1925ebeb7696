"""Shared code of the tests of verbs that need a model."""
from tool_case import ToolCase

COLOUR = ("--config", "crfh_colour")


class TrainedCase(ToolCase):
    """A test with two painted runs and a model of the first, home.places."""

    def setUp(self):
        super().setUp()
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.succeed("train", "monday", "--model", "./home.places", *COLOUR, "--set",
                     "reduction.method=none")
