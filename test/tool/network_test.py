#!/usr/bin/env python3
"""The cue `embedding`: a network by name, in a model, and what is refused."""
import shutil
import unittest

from tool_case import ToolCase


class NetworkTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.network = self.install_network()

    def test_a_model_carries_its_network_and_learns_on(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        before = self.figures("train", "monday", "--model", "./home.places", "--config",
                              "embedding")
        self.network.unlink()
        self.assertGreater(self.figures("evaluate", "--model", "./home.places",
                                        "tuesday")["average_rate"], 0.9)
        after = self.figures("train", "tuesday", "--add-to", "./home.places", "--model",
                             "./later.places")
        self.assertEqual(before["images"], after["images"])
        self.succeed("reduce", "--model", "./later.places", "--out", "./small.places", "--method",
                     "shared-greedy", "--support-vectors", "3")
        self.assertGreater(self.figures("evaluate", "--model", "./small.places",
                                        "tuesday")["average_rate"], 0.9)

    def test_the_same_bytes_whatever_the_number_of_threads(self):
        self.write_run("monday")
        for threads in (1, 3):
            self.succeed("train", "monday", "--model", f"./{threads}.places", "--config",
                         "embedding", "--threads", threads)
        self.assertEqual((self.folder / "1.places").read_bytes(),
                         (self.folder / "3.places").read_bytes())

    def test_what_cannot_be_used_is_refused_in_one_line(self):
        self.write_run("monday")
        train = ("train", "monday", "--model", "./home.places", "--config", "embedding")
        whole = self.network.read_bytes()
        self.network.write_bytes(whole[:len(whole) // 2])
        self.assertIn("mobilenet.onnx", self.refuse(*train))
        self.network.write_bytes(b"no network at all")
        self.assertIn("is not an ONNX file", self.refuse(*train))
        self.network.write_bytes(whole)
        self.assertIn("'absent'", self.refuse(*train, "--set", "cues.embedding.feature.layer=absent"))
        shutil.rmtree(self.network.parent)
        self.assertIn("as mobilenet.onnx", self.refuse(*train))


if __name__ == "__main__":
    unittest.main()
