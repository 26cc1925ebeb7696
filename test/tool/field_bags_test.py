#!/usr/bin/env python3
"""Bags like those described in public reports."""
import json
import os
import unittest

import rosbag
import rospy
from field_case import MODEL, FieldCase
from sensor_msgs.msg import CompressedImage
from std_msgs.msg import String
from tool_case import paint


def unindexed(content):
    """Returns the bag that a killed recorder leaves."""
    content = bytearray(content)
    field = content.index(b"index_pos=") + 10
    content[field:field + 8] = bytes(8)
    return content


class BagTest(FieldCase):
    def test_an_image_that_cannot_be_used_does_not_stop_recognition(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                            [(0, "kitchen"), (5, "office")])
        self.train("run.bag")
        with rosbag.Bag(str(self.folder / "run.bag"), "a") as bag:
            bag.write("/camera/image_raw/compressed", CompressedImage(format="jpeg"),
                      rospy.Time(1011))
            self.write_image("cut.jpg", paint("kitchen", 1))
            cut = CompressedImage(format="jpeg", data=(self.folder / "cut.jpg").read_bytes()[:1500])
            bag.write("/camera/image_raw/compressed", cut, rospy.Time(1012))
        result = self.run_tool("recognize", "run.bag", *MODEL[:2], "--json", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        answers = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual(len(answers), 12)
        self.assertIn("empty", answers[10]["reason"])
        self.assertIn("truncated", answers[11]["reason"])
        self.assertEqual((answers[11]["known"], answers[11]["place"]), (False, ""))
        self.assert_names(result.stderr, "2 images cannot be used")
        for verb in ("train", "evaluate"):
            self.assert_names(self.run_tool(verb, "run.bag", *(MODEL if verb == "train" else
                                                              MODEL[:2])).stderr, "empty")

    def test_a_bag_of_which_no_image_can_be_used_says_why(self):
        self.train(self.write_labelled("run.bag", 1000, ["kitchen"] * 8 + ["office"] * 8,
                                       [(0, "kitchen"), (8, "office")]))
        with rosbag.Bag(str(self.folder / "film.bag"), "w") as bag:
            bag.write("/place_label", String("kitchen"), rospy.Time(1000))
            for i in range(3):
                bag.write("/camera/image_raw/compressed", CompressedImage(format="h264", data=b"film"),
                          rospy.Time(1000 + i))
        for verb in (("train", "film.bag", "--model", "./other.places"),
                     ("evaluate", "film.bag", *MODEL[:2])):
            self.assert_names(self.refuse(*verb), "can be used", "#1", "not an image")
        self.assert_names(self.run_tool("recognize", "film.bag", *MODEL[:2]).stderr, "#1",
                          "not an image")

    def test_a_labels_file_may_end_in_yml_and_a_topic_in_a_slash(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                            [(0, "a"), (5, "b")], topic="/my_label")
        topics = ("--image-topic", "camera/image_raw/", "--label-topic", "my_label/")
        self.assertEqual(self.rooms_of("run.bag", *topics), ["a", "b"])
        (self.folder / "run.labels.yml").write_text(
            "labels: [{from: 0, to: 5, place: kitchen}, {from: 5, place: office}]")
        self.assertEqual(self.rooms_of("run.bag"), ["kitchen", "office"])

    def test_where_the_labels_of_a_bag_may_be(self):
        self.train(self.write_labelled("run.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                                       [(0, "kitchen"), (5, "office")]))
        self.write_labelled("room.bag", 1000, ["kitchen"] * 5, [(0, "kitchen")], topic="/room")
        self.write_labelled("plain.bag", 1000, ["kitchen"] * 5, [])
        for bag, words in (("room.bag", "if a topic of text has its labels, name it: --label-topic /room"),
                           ("plain.bag", "label it with: place_tool label plain.bag")):
            for verb in (("train", bag, "--model", "./other.places"), ("evaluate", bag, *MODEL[:2])):
                self.assert_names(self.run_tool(*verb).stderr, f"in {bag} has a label; {words}.")

    def test_labels_with_commas_are_labels(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 5 + ["office"] * 5, [])
        (self.folder / "labels.dat").write_text("stamp,label\n1000.0,kitchen\n1004.5,office\n")
        figures, said = self.train("run.bag")
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"kitchen": 5, "office": 5})
        self.assertIn("separated by commas", said)

    def test_a_bag_of_a_recorder_that_was_killed(self):
        self.write_labelled("whole.bag", 1000, ["kitchen"] * 3, [(0, "kitchen")])
        content = unindexed((self.folder / "whole.bag").read_bytes())
        (self.folder / "monday.bag.active").write_bytes(content)
        for verb in (("info", "monday.bag.active"), ("train", "monday.bag.active", *MODEL)):
            self.assert_names(self.refuse(*verb), "rosbag reindex monday.bag.active",
                              "rename it to monday.bag")
        for verb in (("info", "monday.bag"), ("train", "monday.bag", *MODEL)):
            self.assert_names(self.refuse(*verb), "monday.bag.active lies beside it",
                              "rosbag reindex monday.bag.active")
        (self.folder / "runs").mkdir()
        self.write_labelled("runs/sound.bag", 1000, ["kitchen"] * 4 + ["office"] * 4,
                            [(0, "kitchen"), (4, "office")])
        (self.folder / "runs/monday.bag.active").write_bytes(content)
        self.assert_names(self.train("runs")[1], "rosbag reindex runs/monday.bag.active",
                          "rename it to runs/monday.bag")

    def test_a_bag_that_cannot_be_read_does_not_stop_a_folder(self):
        labels = [(0, "kitchen"), (4, "office")]
        self.write_labelled("sound.bag", 1000, ["kitchen"] * 4 + ["office"] * 4, labels)
        content = (self.folder / "sound.bag").read_bytes()
        (self.folder / "runs").mkdir()
        (self.folder / "sound.bag").rename(self.folder / "runs/sound.bag")
        with rosbag.Bag(str(self.folder / "runs/laser.bag"), "w") as bag:
            bag.write("/place_label", String("kitchen"), rospy.Time(1000))
        with rosbag.Bag(str(self.folder / "runs/depth.bag"), "w") as bag:
            bag.write("/depth/compressedDepth", CompressedImage(), rospy.Time(1000))
        damaged = {"unindexed": (unindexed(content), "rosbag reindex runs/unindexed.bag"),
                   "cut": (content[:-2000], "copy or record it again"),
                   "text": (b"notes\n", "not a ROS 1 bag")}
        for name, (data, _) in damaged.items():
            (self.folder / f"runs/{name}.bag").write_bytes(data)
        train = ("train", "runs", *MODEL)
        for verb in (train, ("evaluate", "runs", *MODEL[:2]), ("recognize", "runs", *MODEL[:2]),
                     ("calibrate", "runs", *MODEL[:2])):
            result = self.run_tool(*verb)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("Nothing was read from runs/laser.bag: it has no images", result.stderr)
            self.assertIn("Nothing was read from runs/depth.bag: it has only compressedDepth images, "
                          "which cannot be used", result.stderr)
            for name, (_, words) in damaged.items():
                self.assertEqual(result.stderr.count(f"Nothing was read from runs/{name}.bag"), 1)
                self.assertIn(words, result.stderr)
        self.assertEqual(self.train("runs")[0]["images"], 8)
        # An unreadable bag that is named explicitly is an error, and so are unreadable labels.
        for name, (_, words) in damaged.items():
            self.assertIn(words, self.refuse("train", "runs/sound.bag", f"runs/{name}.bag", *MODEL))
        self.assertIn("only compressedDepth images, which cannot be used; its topics are /depth",
                      self.refuse("train", "runs/depth.bag", *MODEL))
        (self.folder / "runs/labels.dat").write_text("kitchen\n")
        self.assertIn("labels.dat, line 1", self.run_tool(*train).stderr.splitlines()[-1])

    def test_a_whole_bag_that_is_named_as_if_it_were_being_recorded(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 4 + ["office"] * 4,
                            [(0, "kitchen"), (4, "office")])
        (self.folder / "run.bag").rename(self.folder / "run.bag.active")
        figures, said = self.train("run.bag.active")
        self.assertEqual(figures["images"], 8)
        for text in (said, self.run_tool("info", "run.bag.active").stderr):
            self.assert_names(text, "run.bag.active is complete", "run: mv run.bag.active run.bag")

    def test_an_empty_bag_says_so(self):
        rosbag.Bag(str(self.folder / "empty.bag"), "w").close()
        text = self.succeed("info", "empty.bag")
        self.assert_names(text, "no messages")
        self.assertNotIn("duration", text)

    def test_recordings_of_other_kinds_are_named(self):
        ros2 = self.folder / "rosbag2_run"
        ros2.mkdir()
        (ros2 / "metadata.yaml").write_text("rosbag2_bagfile_information:\n")
        (ros2 / "rosbag2_run_0.db3").write_bytes(b"SQLite format 3\0")
        (self.folder / "run.mcap").write_bytes(b"\x89MCAP0\r\n")
        (self.folder / "run.bag.gz").write_bytes(b"\x1f\x8b\x08\0")
        (self.folder / "run.zip").write_bytes(b"PK\3\4aaaa")
        (self.folder / "lfs.bag").write_text("version https://git-lfs.github.com/spec/v1\n")
        (self.folder / "page.bag").write_text("<!DOCTYPE html>\n<html></html>\n")
        (self.folder / "empty.bag").write_bytes(b"")
        for name, words in (("rosbag2_run", "ROS 2"), ("run.mcap", "ROS 2"),
                            ("rosbag2_run/rosbag2_run_0.db3", "ROS 2"), ("run.bag.gz", "gunzip"),
                            ("run.zip", "unzip"), ("lfs.bag", "git lfs pull"),
                            ("page.bag", "web page"), ("empty.bag", "empty")):
            for verb in (("info", name), ("train", name, *MODEL)):
                line = self.refuse(*verb)
                self.assert_names(line, name, words)
                self.assertNotIn("byte", line)

    @unittest.skipUnless(os.geteuid() == 0, "to become somebody without rights")
    def test_a_bag_that_may_not_be_read(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 3, [(0, "kitchen")])
        (self.folder / "run.bag").chmod(0)
        result = self.run_as_nobody("info", "run.bag")
        self.assertEqual(result.returncode, 1)
        self.assert_names(result.stderr, "run.bag", "Permission denied")


if __name__ == "__main__":
    unittest.main()
