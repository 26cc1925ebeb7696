#!/usr/bin/env python3
"""Tests in a real browser how the page of place_tool label reviews labels by a model."""
import json
import unittest

import rosbag
import rospy
from label_case import START, TOPIC, raw
from page_case import Keys, PageCase
from tool_case import paint


class DoubtsTest(PageCase):
    def setUp(self):
        super().setUp()
        rooms = ["kitchen"] * 8 + ["corridor"] * 8 + ["office"] * 8
        self.write_bag("monday.bag", [(room, room) for room in rooms])
        self.write_bag("tuesday.bag", [(room, None) for room in rooms])
        self.succeed("train", "monday.bag", "--model", "home", "--config", "crfh_colour")

    def doubts(self):
        return self.script("""return [...document.querySelectorAll("#doubts li")].map(item =>
            [item.querySelector(".what").textContent.replace(/\\s+/g, " ").trim(),
             item.querySelector(".why").textContent.split(" · ").at(-1).split(",")[0]])""")

    def test_a_run_is_labelled_from_a_model(self):
        self.open("tuesday.bag", "--model", "home")
        self.wait(lambda: not self.element("progress").is_displayed() and len(self.doubts()) == 3)
        self.assertEqual({kind for _, kind in self.doubts()}, {"not labelled"})
        self.element("accept-all").click()
        self.wait(lambda: self.doubts() == [])
        self.assertEqual(self.text("model-note"), "The model agrees with all labels.")
        self.save()
        self.assertEqual(self.stretches("tuesday.bag"),
                         [("kitchen", 0, 7.5), ("corridor", 7.5, 15.5), ("office", 15.5, 23)])

    def test_contradictions_come_first_in_order_of_severity(self):
        (self.folder / "tuesday.labels.yaml").write_text(json.dumps({"labels": [
            {"from": 0, "to": 7.5, "place": "kitchen"}, {"from": 7.5, "to": 9.5, "place": "office"},
            {"from": 9.5, "to": 12.5, "place": "corridor"},
            {"from": 15.5, "to": 21.5, "place": "kitchen"}]}))
        self.open("tuesday.bag", "--model", "home")
        self.wait(lambda: not self.element("progress").is_displayed() and len(self.doubts()) == 4)
        self.assertEqual(self.doubts()[:2], [["kitchen → office", "contradicted"],
                                             ["office → corridor", "contradicted"]])
        self.assertEqual([kind for _, kind in self.doubts()[2:]], ["not labelled"] * 2)
        self.press(".")  # goes to the first stretch
        self.assertIn("kitchen", self.text("caption"))
        self.press(Keys.ENTER)  # accepts the answer and goes to the next stretch
        self.wait(lambda: self.doubts()[0] == ["office → corridor", "contradicted"])
        self.press(Keys.BACKSPACE)  # keeps the label
        self.wait(lambda: {kind for _, kind in self.doubts()} == {"not labelled"})
        self.wait_for(("kitchen", 0, 8), ("office", 8, 10), ("corridor", 10, 13),
                      ("office", 16, 22))

    def test_it_learns_from_the_labels(self):
        self.open("tuesday.bag")
        self.assertFalse(self.element("learn").is_enabled())
        for i, room in enumerate(("kitchen", "corridor", "office")):
            self.add_room(room)
            self.drag(i * 8 + .6, i * 8 + 4.6)
            self.press(str(i + 1))
        self.element("learn").click()
        self.wait(lambda: self.doubts() and not self.element("progress").is_displayed())
        self.assertEqual(set(map(tuple, self.doubts())),
                         {(f"no label → {room}", "not labelled")
                          for room in ("kitchen", "corridor", "office")})
        self.element("accept-all").click()
        self.wait(lambda: len(self.drafted()) == 3)
        self.save()
        self.assertEqual([stretch[0] for stretch in self.stretches("tuesday.bag")],
                         ["kitchen", "corridor", "office"])

    def test_a_stretch_that_was_corrected_by_hand_is_no_longer_chosen(self):
        (self.folder / "tuesday.labels.yaml").write_text(json.dumps({"labels": [
            {"from": 0, "to": 7.5, "place": "office"}, {"from": 7.5, "to": 9.5, "place": "office"},
            {"from": 9.5, "to": 15.5, "place": "corridor"},
            {"from": 15.5, "to": 19.5, "place": "kitchen"},
            {"from": 19.5, "to": 23, "place": "office"}]}))
        self.open("tuesday.bag", "--model", "home")
        self.wait(lambda: not self.element("progress").is_displayed() and len(self.doubts()) == 3)
        kitchen = self.rooms_shown()["kitchen"]
        self.press(".", kitchen)  # the first stretch shows the kitchen, not the office
        self.wait(lambda: len(self.doubts()) == 2)
        before = self.drafted()
        self.press(Keys.ENTER)  # nothing is chosen
        self.assertEqual(self.drafted(), before)
        self.press(".")  # the worst one that is left
        self.assertIn("kitchen", self.text("caption"))
        self.press(Keys.ENTER)
        self.wait_for(("kitchen", 0, 8), ("office", 8, 10), ("corridor", 10, 16),
                      ("office", 16, 24))


class TwoCamerasTest(PageCase):
    def test_labels_between_the_frames_of_a_slower_camera_stay(self):
        rooms = ["kitchen"] * 20 + ["corridor"] * 20
        with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            for i, room in enumerate(rooms):
                stamp = rospy.Time.from_sec(START + i / 10)
                bag.write("/fast", raw(paint(room, i), "bgr8"), stamp)
                if i % 10 == 0:
                    bag.write("/slow", raw(paint(room, i), "bgr8"), stamp)
        (self.folder / "run.labels.yaml").write_text(
            "labels: [{from: 0, to: 1.95, place: kitchen}, {from: 1.95, to: 3.9, place: corridor}]")
        self.succeed("train", "run.bag", "--image-topic", "/fast", "--model", "home", "--config",
                     "crfh_colour")
        (self.folder / "run.labels.yaml").write_text("labels: [{from: 0, to: 2.55, place: pantry}]")
        self.open("run.bag", "--image-topic", "/fast", "--model", "home")
        self.wait(lambda: not self.element("progress").is_displayed())
        self.script("""const topic = document.getElementById("topic");
            topic.value = "/slow";
            topic.dispatchEvent(new Event("change"));""")
        self.wait(lambda: "of 4" in self.text("caption"))
        self.element("accept-all").click()
        self.wait_for(("pantry", 0, 26), ("corridor", 26, 40))


if __name__ == "__main__":
    unittest.main()
