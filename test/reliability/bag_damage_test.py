#!/usr/bin/env python3
"""Bags damaged by crashes, bad disks and mistakes: place_tool uses them, or reports in one line
which bag is wrong and how. A few are damaged at random, or 2000 if PLACE_RECOGNITION_FULL_TEST is
set."""
import concurrent.futures
import os
import random
import sys
import unittest

import rosbag
import rospy
from std_msgs.msg import String

sys.path.append(os.environ["PLACE_RECOGNITION_SOURCE_DIR"] + "/test/tool")
from tool_case import ROOMS, ToolCase, paint  # noqa: E402

FULL = "PLACE_RECOGNITION_FULL_TEST" in os.environ
COLOUR = ("--config", "crfh_colour")


def damaged(good, seed):
    """Returns a copy of a bag with a few faults, half of them at the start of records."""
    chance = random.Random(seed)
    content = bytearray(good)
    records = [i for i in range(len(good) - 3) if good[i:i + 3] == b"op="]
    if chance.random() < 0.2:
        del content[chance.randrange(len(content)):]
    for _ in range(2 ** chance.randrange(5)):
        if len(content) < 100:
            break
        near = chance.choice(records) + chance.randrange(-60, 60)
        at = near if chance.random() < 0.5 else chance.randrange(len(content))
        at = min(max(at, 0), len(content) - 8)
        kind = chance.randrange(4)
        if kind == 0:
            content[at] ^= 1 << chance.randrange(8)
        elif kind == 1:
            content[at:at + 4] = chance.choice((b"\0\0\0\0", b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f"))
        elif kind == 2:
            del content[at:at + chance.randrange(40)]
        else:
            content[at:at] = content[at:at + chance.randrange(40)]
    return bytes(content)


class BagDamageTest(ToolCase):
    def setUp(self):
        super().setUp()
        rooms = [room for room in ROOMS for _ in range(4)]
        self.write_bag("good.bag", [(room, room) for room in rooms])
        self.succeed("train", "good.bag", "--model", "./home.places", *COLOUR)

    def verbs(self, bag):
        quiet = ("--progress", "none")
        return (("info", bag), ("evaluate", bag, "--model", "./home.places", *quiet),
                ("train", bag, "--model", f"./{bag}.places", *COLOUR, *quiet))

    def assert_told(self, arguments, bag):
        """Checks that the tool ends by itself, with an answer or one line that names the bag."""
        result = self.run_tool(*arguments)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        if result.returncode == 1:
            lines = [line for line in result.stderr.splitlines() if not line.startswith("warning:")]
            self.assertEqual(len(lines), 1, result.stderr)
            self.assertIn(bag, lines[0])
            self.assertNotIn("near byte 0)", lines[0])
        return result.returncode

    def assert_refused(self, bag, *words, verbs=("info", "evaluate", "train")):
        for arguments in self.verbs(bag):
            if arguments[0] in verbs:
                line = self.refuse(*arguments)
                for word in (bag, *words):
                    self.assertIn(word, line)

    def write(self, name, content):
        (self.folder / name).write_bytes(content)

    def write_labelled(self, name, labels):
        """Writes a bag with one image per second, and with (second, label) in the given order."""
        with rosbag.Bag(str(self.folder / self.write_bag(name, [(room, None) for room in ROOMS])),
                        "a") as bag:
            for second, label in labels:
                bag.write("/place_label", String(label), rospy.Time(1000 + second))

    def good(self):
        return (self.folder / "good.bag").read_bytes()

    def test_random_damage(self):
        count = 2000 if FULL else 10
        good = self.good()

        def outcomes(seed):
            name = f"damaged{seed}.bag"
            self.write(name, damaged(good, seed))
            statuses = [self.assert_told(arguments, name) for arguments in self.verbs(name)]
            (self.folder / name).unlink()
            return statuses

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            statuses = [status for of_bag in pool.map(outcomes, range(count)) for status in of_bag]
        print(f"{count} bags, {len(statuses)} runs, {sum(statuses)} refused")
        self.assertGreater(sum(statuses), count // 4)

    def test_cut_bags(self):
        good = self.good()
        for name, length in (("header.bag", 4096), ("half.bag", len(good) // 2),
                             ("end.bag", len(good) - 1)):
            self.write(name, good[:length])
            self.assert_refused(name)

    def test_unindexed_bag(self):
        good = self.good()
        at = good.index(b"index_pos=") + len(b"index_pos=")
        self.write("unindexed.bag", good[:at] + bytes(8) + good[at + 8:])
        self.assert_refused("unindexed.bag", "rosbag reindex")

    def test_empty_bags(self):
        self.write("nothing.bag", b"")
        self.assert_refused("nothing.bag")
        rosbag.Bag(str(self.folder / "empty.bag"), "w").close()
        self.assert_refused("empty.bag", "image", verbs=("evaluate", "train"))
        self.succeed("info", "empty.bag")

    def test_other_topics_only(self):
        with rosbag.Bag(str(self.folder / "chatter.bag"), "w") as bag:
            bag.write("/chatter", String("hello"), rospy.Time(1))
        self.assert_refused("chatter.bag", "no images", "/chatter", verbs=("evaluate", "train"))
        self.assertIn("/chatter", self.succeed("info", "chatter.bag"))

    def test_labels_out_of_order_count_by_their_time(self):
        rooms = sorted(ROOMS)
        self.write_labelled("shuffled.bag", [(2, rooms[2]), (0, rooms[0]), (1, rooms[1])])
        info = self.figures("info", "shuffled.bag")
        self.assertEqual([label["place"] for label in info["labels"]], rooms)

    def test_two_labels_at_one_time_are_used_or_refused(self):
        self.write_labelled("twice.bag", [(0, "kitchen"), (0, "office"), (1, "corridor")])
        for arguments in self.verbs("twice.bag"):
            self.assert_told(arguments, "twice.bag")

    def test_overlapping_intervals(self):
        self.write_bag("plain.bag", [(room, None) for room in ROOMS])
        (self.folder / "plain.labels.yaml").write_text(
            "labels: [{from: 0, to: 2, place: kitchen}, {from: 1, to: 3, place: office}]")
        for arguments in self.verbs("plain.bag"):
            line = self.refuse(*arguments)
            for word in ("plain.labels.yaml", "kitchen", "office", "overlap"):
                self.assertIn(word, line)

    def test_labels_that_are_not_names(self):
        # rospy writes text as UTF-8, so the invalid byte is inserted afterwards.
        for name, before, after in (("latin.bag", b"kitchen", b"k\xfctchen"),
                                    ("lines.bag", b"kitchen", b"kit\nhen")):
            self.write(name, self.good().replace(before, after))
            self.assert_refused(name, "label")

    def test_a_label_of_a_megabyte(self):
        self.write_labelled("long.bag", [(0, "x" * 1000000)])
        self.assert_refused("long.bag", "label")


if __name__ == "__main__":
    unittest.main()
