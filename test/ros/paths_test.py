#!/usr/bin/env python3
"""Paths as users pass them to launch files and nodes: with blanks and quotes, in the home folder,
relative to the current folder."""
import os
import sys
import unittest

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/ros")
from node_case import Camera, NodeCase  # noqa: E402

ROOMS = "places: [{name: kitchen, position: [[0, 0], [4, 0], [4, 3]]}]"


class PathsTest(NodeCase):
    def setUp(self):
        super().setUp()
        self.trip = self.folder / "Monday's trip"
        self.trip.mkdir()

    def record(self, program, path):
        """Expects that the program records an image to this path, and says so."""
        self.expect(program, f"to {path}.")
        camera = Camera()
        self.addCleanup(camera.close)
        self.wait_for(camera.listeners, "nobody listens")
        self.wait_for(lambda: camera.send() or f"{path}.active" and
                      os.path.getsize(f"{path}.active") > 5000, lambda: program.output)
        self.assertEqual(program.interrupt(), 0, program.output)
        self.assertTrue(path.exists(), program.output)
        self.assertIn(f"{path}: ", program.output)

    def test_record_in_every_way(self):
        for given, path in ((self.trip / "the run.bag", self.trip / "the run.bag"),
                            ("~/run.bag", self.home / "run.bag"),
                            (f"file://{self.home}/run5.bag", self.home / "run5.bag"),
                            ("$HOME/run4.bag", self.home / "run4.bag"),
                            ("run 1.bag", self.trip / "run 1.bag"),
                            ("./run2", self.trip / "run2.bag"),
                            ("../run3.bag", self.trip / "../run3.bag")):
            with self.subTest(str(given)):
                self.record(self.launch("record.launch", f"bag:={given}", cwd=self.trip), path)
        self.record(self.start_node("place_labeler", "_bag:=by rosrun.bag", "image:=/camera/image_raw",
                                    "_image_transport:=compressed", cwd=self.trip),
                    self.trip / "by rosrun.bag")

    def test_auto_record_and_its_rooms(self):
        (self.trip / "the rooms.yaml").write_text(ROOMS)
        self.record(self.launch("auto_record.launch", "bag:=run.bag", "rooms:=the rooms.yaml",
                                cwd=self.trip), self.trip / "run.bag")
        missing = self.launch("auto_record.launch", "bag:=run.bag", "rooms:=~/rooms.yaml", cwd=self.trip)
        self.expect(missing, str(self.home / "rooms.yaml"))

    def test_refusals_name_the_whole_path(self):
        node = self.start_node("place_labeler", "_bag:=nowhere/run.bag", cwd=self.trip)
        self.expect_end(node, 1, f"Cannot write {self.trip / 'nowhere/run.bag'}: the folder "
                        f"{self.trip / 'nowhere'} does not exist; create it, or choose another.")
        (self.trip / "run.bag").touch()
        node = self.start_node("place_labeler", "_bag:=run.bag", cwd=self.trip)
        self.expect_end(node, 1, f"The file {self.trip / 'run.bag'} already exists")
        killed = self.trip / "killed.bag"
        (self.trip / "killed.bag.active").touch()
        node = self.start_node("place_labeler", "_bag:=killed.bag", cwd=self.trip)
        self.expect_end(node, 1, f"rosbag reindex {killed}.active, and rename it to {killed} "
                        f"({killed}.orig.active is its backup); in either case set ~bag to another name")
        (self.trip / "old.labels.yaml").write_text("labels: []")
        node = self.start_node("place_labeler", "_bag:=old.bag", cwd=self.trip)
        self.expect_end(node, 1, f"The labels of {self.trip / 'old.bag'} would be replaced by those in "
                        f"{self.trip / 'old.labels.yaml'}")
        node = self.start_node("place_labeler", f"_bag:={self.trip}")
        self.expect_end(node, 1, f"{self.trip} is a folder")
        node = self.start_node("place_labeler", "_bag:=new/", cwd=self.trip)
        self.expect_end(node, 1, f"{self.trip / 'new'}/ is a folder")
        node = self.start_node("place_labeler", "_bag:=$NO_SUCH_VARIABLE/run.bag")
        self.expect_end(node, 1, "The environment variable NO_SUCH_VARIABLE", "is not set")
        node = self.start_node("place_labeler", "_bag:=~nobody_of_this_name/run.bag")
        self.expect_end(node, 1, "There is no user 'nobody_of_this_name'")

    def test_bag_roots(self):
        node = self.launch("train.launch", "bag_roots:=[Monday's trip, ~/bags]")
        self.expect(node, f"The folder {self.home}/bags in ~bag_roots does not exist")
        self.assertEqual(node.output.count("does not exist"), 1, node.output)
        node.interrupt()

    def test_adjacency(self):
        (self.trip / "the map.yaml").write_text("rooms: {}")
        node = self.launch("recognize.launch", "adjacency:=the map.yaml", cwd=self.trip)
        self.expect(node, "no model to recognize with")
        node.interrupt()


if __name__ == "__main__":
    unittest.main()
