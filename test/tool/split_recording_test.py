#!/usr/bin/env python3
"""Recordings that were split into several bags."""
import json
import unittest

from field_case import MODEL, FieldCase


class SplitRecordingTest(FieldCase):
    def test_labels_of_a_split_recording_hold_in_its_next_part(self):
        self.write_labelled("run_0.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                            [(0, "kitchen"), (5, "office")])
        self.write_labelled("run_1.bag", 1010, ["office"] * 6, [])
        self.write_labelled("run_2.bag", 1016, ["office"] * 3 + ["corridor"] * 6, [(3, "corridor")])
        self.write_labelled("late.bag", 5000, ["office"] * 6, [])
        figures, said = self.train("run_0.bag", "run_1.bag", "run_2.bag", "late.bag")
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"kitchen": 5, "office": 14, "corridor": 6})
        self.assert_names(said, "run_1.bag continues where run_0.bag ends, and starts in 'office'",
                          "late.bag has no labels", "place_tool label late.bag")
        figures, said = self.train("run_2.bag", "run_1.bag", "run_0.bag")  # in any order
        self.assertEqual(figures["rooms"]["office"]["count"], 14)
        self.assertNotIn("warning: run_", said)
        self.assert_names(self.train("run_2.bag", "run_0.bag")[1],
                          "run_2.bag starts without a label", "--repeat-latched")
        self.assert_names(self.run_tool("train", "run_1.bag", *MODEL).stderr,
                          "run_1.bag has no labels", "--repeat-latched")
        (self.folder / "late.bag").unlink()
        self.assertEqual(self.train(".")[0]["images"], 25)

    def test_parts_follow_each_other_in_whatever_order_they_are_given(self):
        frames = [room for room in ("kitchen", "office", "corridor", "office") for _ in range(9)]
        parts = [self.write_labelled(f"run_{number}.bag", 1000 + start, frames[start:start + 12],
                                     enumerate(frames[start:start + 12]))
                 for number, start in ((1, 0), (2, 12), (10, 24))]
        other = self.write_labelled("other.bag", 9000, frames[:9], [(0, "kitchen")])
        models = []
        for runs in ((other, *parts), (other, *sorted(parts))):  # run_10 before run_2
            self.train(*runs)
            models.append((self.folder / "home.places").read_bytes())
        self.assertEqual(*models)
        figures = [self.figures("evaluate", *runs, *MODEL[:2])["over_time"]
                   for runs in (parts, sorted(parts))]
        self.assertEqual(*figures)
        images = [[json.loads(line)["image"] for line in self.succeed(
            "recognize", *runs, *MODEL[:2], "--json", "-").splitlines()]
            for runs in (parts, sorted(parts))]
        self.assertEqual(len(images[0]), len(frames))
        self.assertEqual(*images)

    def test_parts_are_evaluated_as_one_run(self):
        frames = [room for room in ("kitchen", "office") for _ in range(9)] * 2
        self.write_labelled("run_0.bag", 1000, frames[:20], enumerate(frames[:20]))
        self.write_labelled("run_1.bag", 1020, frames[20:], enumerate(frames[20:]))
        self.train("run_0.bag")
        figures = self.figures("evaluate", "run_0.bag", "run_1.bag", *MODEL[:2])
        self.assertEqual([run["name"] for run in figures["runs"]], ["run_0.bag"])
        self.assertNotIn("mean over the rooms of all runs",
                         self.succeed("evaluate", "run_0.bag", "run_1.bag", *MODEL[:2]))

    def test_each_camera_continues_its_own_recording(self):
        rooms = ["kitchen"] * 8 + ["office"] * 8
        for camera in ("front", "rear"):
            for part, start in ((0, 1000), (1, 1008)):
                labels = [(0, "kitchen")] if (camera, part) == ("front", 0) else []
                self.write_labelled(f"{camera}_{part}.bag", start, rooms[8 * part:8 * part + 8],
                                    labels, camera=f"/{camera}/image_raw")
        self.write_labelled("home.bag", 9050, rooms, [(0, "kitchen"), (8, "office")])
        figures, said = self.train("front_0.bag", "rear_0.bag", "front_1.bag", "rear_1.bag",
                                   "home.bag")
        self.assert_names(said, "front_1.bag continues where front_0.bag ends, and starts in "
                                "'kitchen'", "rear_0.bag has no labels",
                          "rear_1.bag continues where rear_0.bag ends, in no place")
        self.assertEqual(figures["rooms"]["kitchen"]["count"], 16 + 8)

    def test_of_two_robots_the_name_tells_the_part(self):
        for one, two in (("alice", "bob"), ("robot1", "robot2"), ("1/run", "2/run")):
            for folder in ("1", "2"):
                (self.folder / folder).mkdir(exist_ok=True)
            self.write_labelled(f"{one}_0.bag", 1000, ["kitchen"] * 8, [(0, "kitchen")])
            self.write_labelled(f"{two}_0.bag", 1000, ["office"] * 8, [(0, "office")])
            self.write_labelled(f"{two}_1.bag", 1008, ["office"] * 4, [])
            said = self.train(f"{one}_0.bag", f"{two}_0.bag", f"{two}_1.bag")[1]
            self.assertIn(f"{two}_1.bag continues where {two}_0.bag ends, and starts in 'office'",
                          said)
        self.write_labelled("carol.bag", 1008, ["corridor"] * 4, [])
        figures, said = self.train("bob_0.bag", "alice_0.bag", "bob_1.bag", "carol.bag")
        self.assertIn("carol.bag may continue bob_0.bag or alice_0.bag", said)
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"kitchen": 8, "office": 12})

    def test_parts_of_a_slow_camera(self):
        self.write_labelled("slow_0.bag", 1000, ["office"] * 4 + ["kitchen"] * 4,
                            [(0, "office"), (20, "kitchen")], interval=5)
        self.write_labelled("slow_1.bag", 1040, ["kitchen"] * 4, [], interval=5)
        figures, said = self.train("slow_0.bag", "slow_1.bag")
        self.assertIn("slow_1.bag continues where slow_0.bag ends", said)
        self.assertEqual(figures["rooms"]["kitchen"]["count"], 8)
        self.assertEqual(len(self.figures("evaluate", "slow_0.bag", "slow_1.bag",
                                          *MODEL[:2])["runs"]), 1)

    def test_a_part_may_start_in_no_place(self):
        self.write_labelled("run_0.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                            [(0, "kitchen"), (5, "office"), (9, "")])
        self.write_labelled("run_1.bag", 1010, ["office"] * 6, [(3, "office")])
        said = self.train("run_0.bag", "run_1.bag")[1]
        self.assertIn("run_1.bag continues where run_0.bag ends, in no place", said)
        self.assertNotIn("starts without a label", said)


if __name__ == "__main__":
    unittest.main()
