#!/usr/bin/env python3
"""Tests the answers of a model that place_tool label shows beside the labels."""
import time
import unittest

import rosbag
import rospy
from label_case import IN_ASCII, TOPIC, LabelCase, span


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

    def test_it_learns_from_the_topic_shown(self):
        self.write_bag("run.bag", [(room, None) for room in self.rooms])
        self.record("rear.bag", topics=("/rear/compressed",))
        page = self.page("rear.bag", "run.bag", "--image-topic", "/rear/compressed")
        start = next(bag["offset"] for bag in page.get("recording")["bags"]
                     if bag["name"] == "run.bag")
        spans = [span(start, start + 5.5, "kitchen"), span(start + 5.5, start + 11.5, "corridor")]
        page.post("learn", {"spans": spans, "topic": "/rear/compressed"})
        self.assertIn("no labelled bag has images on /rear", self.problem(page))
        self.assertEqual(page.post("learn", {"spans": spans, "topic": TOPIC})[0], 200)
        self.assertEqual([answer[1] for answer in self.answers(page)][:12], self.rooms[:12])
        self.assertEqual(page.post("learn", {"spans": spans, "topic": "/left"})[0], 422)

    def test_failures_are_reported(self):
        self.write_bag("run.bag", [(room, None) for room in self.rooms])
        page = self.page("run.bag")
        page.post("learn", {"spans": [span(0, 5, "kitchen")]})
        self.assertIn("place", self.problem(page))


if __name__ == "__main__":
    unittest.main()
