#!/usr/bin/env python3
"""Tests place_tool label without a browser: what its server sends, refuses and writes."""
import http.client
import json
import os
import pathlib
import tempfile
import time
import unicodedata
import unittest

import rosbag
import rospy
from label_case import START, TOPIC, LabelCase, Page, span
from sensor_msgs.msg import CompressedImage
from std_msgs.msg import String

# A locale that is not UTF-8, as an 8-bit one is; every system has this one.
IN_ASCII = {"LC_ALL": "POSIX", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}


class AddressTest(LabelCase):
    """Tests that only the page itself is answered. All tests share a server, because none changes
    anything."""
    served = None

    def setUp(self):
        super().setUp()
        if AddressTest.served is None:
            folder = tempfile.TemporaryDirectory(prefix="place_tool_test_")
            self.addClassCleanup(folder.cleanup)
            AddressTest.shared = pathlib.Path(folder.name)
            self.record(AddressTest.shared / "run.bag")
            AddressTest.served = Page(AddressTest.shared, self.environment(), "run.bag")
            self.addClassCleanup(AddressTest.served.stop)

    def status(self, *arguments, **headers):
        return self.served.request(*arguments, **headers)[0]

    def test_it_listens_on_loopback_only(self):
        port = f"{self.served.port:04X}"
        with open("/proc/net/tcp") as table:
            listening = [line.split()[1] for line in table if line.split()[3] == "0A"]
        self.assertEqual([address for address in listening if address.endswith(":" + port)],
                         ["0100007F:" + port])

    def test_nothing_without_the_token(self):
        for path in ("/", "/recording", "/x/recording", "/index.html", self.served.path[:-2] + "/"):
            self.assertEqual(self.status("GET", path), 403, path)
        self.assertEqual(self.status("GET", ""), 200)

    def test_no_other_name_for_this_computer(self):
        for host in ("evil.example", f"evil.example:{self.served.port}", "127.0.0.1.evil.example"):
            self.assertEqual(self.status("GET", "recording", Host=host), 421, host)
        self.assertEqual(self.status("GET", "recording", Host="localhost:1234"), 200)

    def test_no_other_origin(self):
        for origin in ("http://evil.example", "null", "https://127.0.0.1:%d" % self.served.port,
                       "http://127.0.0.1:1"):
            self.assertEqual(self.status("GET", "recording", Origin=origin), 403, origin)
            self.assertEqual(self.status("POST", "goodbye", "{}", Origin=origin), 403, origin)
        self.assertEqual(self.status("POST", "goodbye", "{}", Origin=""), 403)
        self.assertEqual(self.status("POST", "goodbye", "{}"), 200)
        for site in ("cross-site", "same-site"):
            self.assertEqual(self.status("GET", "recording", Sec_Fetch_Site=site), 403, site)

    def test_one_connection_carries_several_requests(self):
        connection = http.client.HTTPConnection("127.0.0.1", self.served.port, timeout=60)
        for _ in range(2):
            connection.request("POST", self.served.path + "goodbye", '{"more": "than is read"}',
                               {"Origin": f"http://127.0.0.1:{self.served.port}"})
            self.assertEqual(connection.getresponse().read(), b"{}")
            connection.request("GET", self.served.path + "times?topic=" + TOPIC)
            self.assertEqual(len(json.loads(connection.getresponse().read())), 40)
        connection.close()

    def test_no_file_but_those_of_the_page(self):
        for name in ("../server.py", "..%2fserver.py", "server.py", "/etc/passwd", "nothing"):
            path = self.served.path + name
            self.assertIn(self.status("GET", path), (403, 404), name)
        self.assertEqual(self.status("GET", "main.js"), 200)

    def test_malformed_requests_are_refused_and_change_nothing(self):
        for name, body in (("save", "{"), ("save", "[]"), ("save", '{"spans": [{}]}'),
                           ("save", '{"spans": [{"from": 0, "to": "a", "place": "b"}]}'),
                           ("save", '{"spans": [{"from": 0, "to": 1%s, "place": "b"}]}' % ("0" * 400)),
                           ("save", "[" * 100000), ("draft", '{"spans": 5}'), ("draft", '{"spans": {}}'),
                           ("draft", '{"spans": [5]}'), ("draft", '{"spans": [{"from": 0, "to": 1}]}'),
                           ("draft", '{"spans": [{"from": 0, "to": NaN, "place": "b"}]}'),
                           ("draft", '{"spans": [{"from": 0, "to": 1, "place": 5}]}')):
            self.assertEqual(self.status("POST", name, body), 400, body[:80])
        for query in ("times?topic=/no", "picture?topic=/no&frame=0&size=thumb",
                      f"picture?topic={TOPIC}&frame=0", "answers?question=a&after=0", "times"):
            self.assertEqual(self.status("GET", query), 400, query)
        self.assertEqual(self.status("GET", f"picture?topic={TOPIC}&frame=40&size=thumb"), 404)
        self.assertEqual([path.name for path in self.shared.iterdir()], ["run.bag"])


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


class OpinionTest(LabelCase):
    def setUp(self):
        super().setUp()
        self.rooms = ["kitchen"] * 6 + ["corridor"] * 6 + ["office"] * 6

    def answers(self, page):
        """Waits for all answers and returns them."""
        for _ in range(600):
            status = page.get("recording")["opinion"]
            self.assertEqual(status["problem"], "")
            if status["answers"] == status["frames"] and not status["stage"]:
                return page.get(f"answers?question={status['question']}&after=0")
            time.sleep(.1)
        self.fail(f"no answers: {status}")

    def problem(self, page):
        """Waits for a failure and returns it."""
        for _ in range(300):
            problem = page.get("recording")["opinion"]["problem"]
            if problem:
                return problem
            time.sleep(.1)
        self.fail("no problem is reported")

    def test_a_model_answers_each_frame(self):
        self.write_bag("monday.bag", [(room, room) for room in self.rooms])
        self.write_bag("tuesday.bag", [(room, None) for room in self.rooms])
        self.succeed("train", "monday.bag", "--model", "home", "--config", "crfh_colour")
        page = self.page("tuesday.bag", "--model", "home")
        answers = self.answers(page)
        self.assertEqual([answer[0] for answer in answers], list(range(18)))
        self.assertEqual([answer[1] for answer in answers], self.rooms)
        for _, place, probabilities, unknown in answers:
            self.assertAlmostEqual(sum(probabilities.values()) + unknown, 1, delta=.05)
            self.assertEqual(max(probabilities, key=probabilities.get), place)
        self.assertEqual(page.get("answers?question=99&after=0"), [])

    def test_answers_belong_to_the_frames_that_are_shown(self):
        self.write_bag("monday.bag", [(room, room) for room in self.rooms])
        self.write_bag("tuesday.bag", [("office", None)] * 3)
        with rosbag.Bag(str(self.folder / "tuesday.bag"), "a") as bag:
            image = [message for _, message, _ in bag.read_messages()][0]
            for i in range(6):
                bag.write(TOPIC, image, rospy.Time(200000 + i))
        self.succeed("train", "monday.bag", "--model", "home", "--config", "crfh_colour")
        answers = self.answers(self.page("tuesday.bag", "--model", "home"))
        self.assertEqual([answer[0] for answer in answers], list(range(6)))

    def test_it_learns_from_the_labels_of_the_page(self):
        self.write_bag("run.bag", [(room, None) for room in self.rooms * 2])
        page = self.page("run.bag")
        before = self.files()
        spans = [span(begin, begin + 6, room) for begin, room in
                 ((-.5 + 0, "kitchen"), (5.5, "corridor"), (11.5, "office"))]
        self.assertEqual(page.post("learn", {"spans": spans})[0], 200)
        places = [answer[1] for answer in self.answers(page)]
        self.assertGreaterEqual(sum(a == b for a, b in zip(places, self.rooms * 2)), 32)
        self.assertEqual(self.files(), before)

    def test_it_learns_names_in_a_locale_without_utf_8(self):
        self.write_bag("run.bag", [(room, None) for room in self.rooms])
        self.extra_environment = IN_ASCII
        page = self.page("run.bag")
        spans = [span(0, 5.5, "K\u00fcche"), span(5.5, 11.5, "corridor")]
        self.assertEqual(page.post("learn", {"spans": spans})[0], 200)
        self.assertIn("K\u00fcche", [answer[1] for answer in self.answers(page)])

    def test_it_learns_from_the_bags_that_have_the_topic_shown(self):
        self.write_bag("run.bag", [(room, None) for room in self.rooms])
        self.record("rear.bag", topics=("/rear/compressed",))
        page = self.page("run.bag", "rear.bag", "--image-topic", TOPIC)
        start = next(bag["offset"] for bag in page.get("recording")["bags"]
                     if bag["name"] == "rear.bag")
        spans = [span(0, 5.5, "kitchen"), span(5.5, 11.5, "corridor"),
                 span(start, start + 1, "attic")]
        self.assertEqual(page.post("learn", {"spans": spans})[0], 200)
        self.assertEqual([answer[1] for answer in self.answers(page)][:12], self.rooms[:12])
        page.post("learn", {"spans": spans[2:]})
        self.assertIn("no labelled bag has images on " + TOPIC, self.problem(page))

    def test_failures_are_reported(self):
        self.write_bag("run.bag", [(room, None) for room in self.rooms])
        page = self.page("run.bag")
        page.post("learn", {"spans": [span(0, 5, "kitchen")]})
        self.assertIn("place", self.problem(page))


if __name__ == "__main__":
    unittest.main()
