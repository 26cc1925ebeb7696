#!/usr/bin/env python3
"""Tests which labels files place_tool label writes and keeps, without a browser."""
import json
import os
import unicodedata
import unittest

import rosbag
import rospy
from label_case import IN_ASCII, START, TOPIC, LabelCase, span
from sensor_msgs.msg import CompressedImage
from std_msgs.msg import String


class SavingTest(LabelCase):
    def save(self, page, *spans, **more):
        status, answer = page.post("save", {"spans": spans, **more})
        self.assertEqual(status, 200, answer)

    def test_frames_get_the_labels_that_the_page_shows(self):
        self.record("run.bag")
        page = self.page("run.bag")
        self.assertEqual(page.get("recording")["spans"], [])
        self.save(page, span(0, 1.05, "kitchen"), span(1.05, 2.0, "corridor"), span(3, 4, "kitchen"))
        # Borders are moved between frames, whatever the page sent.
        self.assertEqual(self.stretches("run.bag"), [("kitchen", 0, 1.05), ("corridor", 1.05, 1.95),
                                                     ("kitchen", 2.95, 3.9)])
        self.assertEqual(self.files(), ["run.bag", "run.labels.yaml"])

    def test_what_was_loaded_is_saved_unchanged(self):
        rooms = [(0, "kitchen"), (7, ""), (9, "corridor"), (20, "kitchen"), (39, "office")]
        self.record("run.bag", rate=30, labels=rooms)
        before = self.stretches("run.bag")
        page = self.page("run.bag")
        self.save(page, *page.get("recording")["spans"])
        after = self.stretches("run.bag")
        self.assertEqual([stretch[0] for stretch in after], [stretch[0] for stretch in before])
        for (_, begin, end), (_, begin_after, end_after) in zip(before, after):
            self.assertTrue(begin - 1 / 30 < begin_after <= begin + 1e-6)
            self.assertTrue(end - 1 / 30 < end_after <= end + 1e-6)
        text = self.text("run.labels.yaml")
        page = self.page("run.bag")
        self.save(page, *page.get("recording")["spans"])
        self.assertEqual(self.text("run.labels.yaml"), text)

    def test_the_previous_file_is_kept(self):
        self.record("run.bag")
        by_hand = "# mine\nlabels: [{from: 0, place: attic}]\n"
        (self.folder / "run.labels.yaml").write_text(by_hand)
        page = self.page("run.bag")
        self.assertEqual([label["place"] for label in page.get("recording")["spans"]], ["attic"])
        self.save(page, span(0, 1, "kitchen"))
        self.save(page, span(0, 1, "corridor"))
        self.assertEqual(self.text("run.labels.yaml.old"), by_hand)
        self.assertEqual(self.stretches("run.bag")[0][0], "corridor")
        self.assertEqual(self.files(), ["run.bag", "run.labels.yaml", "run.labels.yaml.old"])

    def test_a_file_that_somebody_else_has_changed_is_not_overwritten(self):
        self.record("run.bag")
        page = self.page("run.bag")
        other = "labels: [{from: 0, place: attic}]\n"
        (self.folder / "run.labels.yaml").write_text(other)
        spans = [span(0, 1, "kitchen")]
        status, answer = page.post("save", {"spans": spans})
        self.assertEqual(status, 409)
        self.assertIn("run.labels.yaml", answer["problem"])
        self.assertEqual(self.text("run.labels.yaml"), other)
        self.save(page, *spans, overwrite=True)
        self.assertEqual(self.text("run.labels.yaml.old"), other)

    def test_what_another_page_has_changed_is_not_overwritten(self):
        self.record("run.bag")
        page = self.page("run.bag")
        first, second = (page.get("recording")["page"] for _ in range(2))
        mine, other = [span(0, 1, "kitchen")], [span(2, 3, "attic")]
        self.assertEqual(page.post("draft", {"page": second, "spans": other})[0], 200)
        self.assertEqual(page.post("save", {"page": second, "spans": other})[0], 200)
        for name in ("draft", "save"):
            status, answer = page.post(name, {"page": first, "spans": mine})
            self.assertEqual(status, 409)
            self.assertIn("another page", answer["problem"])
        self.assertEqual(self.stretches("run.bag")[0][0], "attic")
        self.assertEqual(page.get("recording")["spans"], other)
        self.assertEqual(page.post("save", {"page": first, "spans": mine, "overwrite": True})[0], 200)
        self.assertEqual(page.post("draft", {"page": first, "spans": mine})[0], 200)
        self.assertEqual(page.post("draft", {"page": second, "spans": other})[0], 409)

    def test_going_back_to_what_is_saved_leaves_nothing_unsaved(self):
        self.record("run.bag")
        page = self.page("run.bag")
        number = page.get("recording")["page"]
        spans = [span(0, 1, "kitchen")]
        page.post("save", {"page": number, "spans": spans})
        page.post("draft", {"page": number, "spans": [], "saved": False})
        self.assertTrue(page.get("recording")["unsaved"])
        page.post("draft", {"page": number, "spans": spans, "saved": True})
        self.assertFalse(page.get("recording")["unsaved"])

    def test_all_labels_can_be_removed(self):
        self.record("run.bag", labels=[(0, "kitchen")])
        page = self.page("run.bag")
        self.save(page)
        self.assertEqual(self.stretches("run.bag"), [])

    def test_spans_that_make_no_sense_are_refused(self):
        self.record("run.bag")
        page = self.page("run.bag")
        for spans in ([span(0, 2, "a"), span(1, 3, "b")], [span(2, 1, "a")], [span(0, 1, "")],
                      [span(0, 1, "unknown")], [span(0, 1, "a\nb")], [span(0, 1, "x" * 129)],
                      [span(0, 1, "\ud800")], [span(0, 1, 3)]):
            with self.subTest(spans=spans):
                status, content = page.request("POST", "save", json.dumps({"spans": spans}))
                self.assertEqual(status, 422, content)
        self.assertEqual(self.files(), ["run.bag"])

    def test_a_bag_whose_name_starts_with_a_dash(self):
        self.record("--help.bag")
        page = self.page("--label=-room", "--", "--help.bag")
        self.assertEqual([label["place"] for label in page.get("recording")["spans"]], ["-room"])
        self.save(page, span(0, 4, "kitchen"))
        self.assertEqual(self.stretches("./--help.bag"), [("kitchen", 0, 3.9)])

    def test_a_bag_with_the_name_of_an_active_one_is_labelled_by_the_file_of_its_run(self):
        self.record("run.bag.active")
        page = self.page("run.bag.active")
        self.save(page, span(0, 4, "kitchen"))
        self.assertEqual(self.stretches("run.bag.active"), [("kitchen", 0, 3.9)])

    def test_a_disk_that_refuses_leaves_nothing_behind(self):
        self.record("run.bag")
        page = self.page("run.bag")
        (self.folder / "run.labels.yaml.old").mkdir()
        (self.folder / "run.labels.yaml").write_text("labels: []")
        status, answer = page.post("save", {"spans": [span(0, 1, "a")], "overwrite": True})
        self.assertEqual(status, 422)
        self.assertIn("run.labels.yaml.old: Is a directory", answer["problem"])
        self.assertEqual(self.text("run.labels.yaml"), "labels: []")
        self.assertEqual(self.files(), ["run.bag", "run.labels.yaml", "run.labels.yaml.old"])

    def test_every_character_that_a_name_may_have(self):
        text = "".join(chr(code) for code in range(0x20, 0x110000)
                       if not 0x7f <= code < 0xa0 and not 0xd800 <= code < 0xe000
                       and unicodedata.category(chr(code)) != "Cn")
        names, name = [], ""
        for character in text:
            if len((name + character).encode()) > 60:  # composing may make a text longer
                names.append(name)
                name = ""
            name += character
        names.append(name)
        with rosbag.Bag(str(self.folder / "said.bag"), "w") as said, \
                rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            for i, name in enumerate(names):
                said.write("/place_label", String(name), rospy.Time.from_sec(START + i))
                bag.write(TOPIC, CompressedImage(), rospy.Time.from_sec(START + i))
        kept = [stretch[0] for stretch in self.stretches("said.bag")]
        self.assertGreater(len(set("".join(kept))), 280_000)
        self.assertTrue(kept[0].startswith("!\"#$%"))
        page = self.page("run.bag")
        spans = [span(max(0, i - .5), i + .5, name) for i, name in enumerate(names)]
        self.save(page, *spans)
        self.assertEqual([stretch[0] for stretch in self.stretches("run.bag")], kept)
        page = self.page("run.bag")
        self.assertEqual([label["place"] for label in page.get("recording")["spans"]], kept)

    def test_two_ways_of_writing_a_name_are_one_room(self):
        self.record("run.bag")
        page = self.page("run.bag")
        self.save(page, span(0, 1, " K\u00fcche"), span(1, 2, "Ku\u0308che\u00a0"),
                  span(2, 3, "K\u200b\u00fc\u00adche"), span(3, 3.5, "the \u00a0\u2003 hall"))
        self.assertEqual([stretch[0] for stretch in self.stretches("run.bag")],
                         ["K\u00fcche", "the hall"])

    def test_names_in_a_locale_without_utf_8(self):
        self.record("K\u00fcche.bag", labels=[(0, "K\u00fcche")])
        self.extra_environment = IN_ASCII
        page = self.page("K\u00fcche.bag")
        spans = page.get("recording")["spans"]
        self.assertEqual([label["place"] for label in spans], ["K\u00fcche"])
        self.save(page, span(0, 2, "K\u00fcche"), span(2, 4, "\u5eca\u4e0b"))
        self.assertEqual([stretch[0] for stretch in self.stretches("K\u00fcche.bag")],
                         ["K\u00fcche", "\u5eca\u4e0b"])

    def test_a_bag_whose_name_is_not_utf_8(self):
        name = os.fsdecode(b"K\xfcche.bag")
        self.record("run.bag")
        os.rename(self.folder / "run.bag", self.folder / name)
        self.extra_environment = {"PYTHONIOENCODING": "utf-8:strict"}
        page = self.page(name)
        self.assertEqual(page.get("recording")["bags"][0]["name"], "K?che.bag")
        self.save(page, span(0, 2, "attic"))
        self.assertEqual(self.stretches(name)[0][0], "attic")


if __name__ == "__main__":
    unittest.main()
