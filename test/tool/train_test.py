#!/usr/bin/env python3
"""Tests place_tool train on painted rooms, as used by people and by programs."""
import json
import shutil
import unittest

import numpy as np
from tool_case import ROOMS, ToolCase, paint

COLOUR = ("--config", "crfh_colour")


class TrainTest(ToolCase):
    def test_figures_say_what_was_learned(self):
        self.write_run("monday")
        figures = self.figures("train", "monday", "--model", "home", *COLOUR)
        self.assertEqual(figures["images"], 24)
        self.assertEqual(figures["rooms"], {room: {"count": 8} for room in sorted(ROOMS)})
        self.assertGreater(figures["support_vectors"], 0)
        self.assertLessEqual(figures["support_vectors"], figures["support_vectors_before"])
        self.assertEqual(figures["validation"]["average_rate"], 1)
        model = self.folder / "ros_home/place_recognition/models/home.places"
        self.assertEqual(model.stat().st_size, figures["model_bytes"])

    def test_fewer_vectors_are_kept_on_request(self):
        self.write_run("monday")
        figures = self.figures("train", "monday", "--model", "home", *COLOUR, "--set",
                               "reduction.method=shared-greedy", "--set", "reduction.share=0.5")
        self.assertLess(figures["support_vectors"], figures["support_vectors_before"])

    def test_text_names_rooms_counts_and_file(self):
        self.write_run("monday")
        text = self.succeed("train", "monday", "--model", "./home.places")
        for words in (*ROOMS, "24 images", "./home.places", "support vectors", "gamma"):
            self.assertIn(words, text)

    def test_same_inputs_give_the_same_bytes(self):
        self.write_run("monday")
        for name, threads in (("a", 1), ("b", 2)):
            self.succeed("train", "monday", "--model", f"./{name}.places", "--threads", threads)
        self.assertEqual((self.folder / "a.places").read_bytes(),
                         (self.folder / "b.places").read_bytes())

    def test_inputs_may_be_bags_folders_and_folders_of_these(self):
        self.write_run("monday")
        self.write_run("week/tuesday", seed=1)
        self.write_bag("week/wednesday.bag", [(room, room) for room in ROOMS for _ in range(4)])
        figures = self.figures("train", "monday", "week", "--model", "./home.places")
        self.assertEqual(figures["images"], 24 + 24 + 12)

    def test_bags_are_labelled_by_topic_file_or_option(self):
        rooms = [room for room in ROOMS for _ in range(4)]
        self.write_bag("topic.bag", [(room, room) for room in rooms])
        self.write_bag("file.bag", [(room, None) for room in rooms])
        (self.folder / "places.txt").write_text(
            "".join(f"{1000 + i} {room}\n" for i, room in enumerate(rooms)))
        by_topic = self.figures("train", "topic.bag", "--model", "./a.places")
        by_file = self.figures("train", "file.bag", "--labels", "places.txt", "--model",
                               "./b.places")
        self.assertEqual(by_topic["rooms"], by_file["rooms"])
        figures = self.figures("evaluate", "file.bag", "--label", "kitchen", "--model",
                               "./a.places")
        self.assertEqual(list(figures["rooms"]), ["kitchen"])

    def test_bags_that_share_a_file_of_labels_are_named(self):
        for name in ("plain.1", "plain.2"):
            self.write_bag(name, [(room, room) for room in ROOMS for _ in range(4)])
        train = ("train", "plain.1", "plain.2", "--model", "./home.places", *COLOUR)
        self.assertNotIn("plain.labels.yaml", self.run_tool(*train).stderr)
        (self.folder / "plain.labels.yaml").write_text(
            "labels: [{from: 0, to: 5.5, place: kitchen}, {from: 5.5, place: corridor}]")
        result = self.run_tool(*train)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr,
                         "warning: .*plain.labels.yaml labels both plain.1 and plain.2; .* rename")
        self.assertNotIn("labels both", self.run_tool(*train, "--label", "kitchen").stderr)


    def test_it_learns_on_from_a_model_within_a_limit(self):
        self.write_run("monday", rooms=("kitchen", "corridor"))
        self.write_run("tuesday", seed=1, rooms=("office",))
        self.succeed("train", "monday", "--model", "./home.places", *COLOUR)
        figures = self.figures("train", "tuesday", "--add-to", "./home.places", "--limit", 10,
                               "--model", "./home.places")
        self.assertEqual(figures["rooms"], {room: {"count": 8} for room in sorted(ROOMS)})
        self.assertLessEqual(figures["support_vectors"], 10)
        self.assertIn("--add-to", self.refuse("train", "tuesday", "--add-to", "./home.places",
                                              "--config", "crfh", "--model", "./home.places",
                                              status=2))


    def test_it_learns_from_the_model_of_another_robot(self):
        self.write_run("first", rooms=("kitchen", "corridor"))
        self.write_run("second", seed=1, rooms=("corridor", "office"))
        self.succeed("train", "first", "--model", "./a.places", *COLOUR)
        self.succeed("train", "second", "--model", "./b.places", *COLOUR)
        joined = ("train", "--add-to", "./a.places", "--from-model", "./b.places", "--model",
                  "./both.places")
        self.assertIn("Learned 3 places from 0 images and the model ./b.places",
                      self.succeed(*joined))
        self.assertEqual(self.figures(*joined, "--limit", 12, "--forgetting", "0.5")["rooms"],
                         {"corridor": {"count": 16}, "kitchen": {"count": 8}, "office": {"count": 8}})
        self.write_run("later", seed=2)
        self.assertEqual(self.figures("evaluate", "later", "--model", "./both.places")["average_rate"],
                         1)
        self.succeed("train", "second", "--model", "./b.places", "--config", "lbp")
        self.assertIn("cannot join", self.refuse(*joined))
        self.assertIn("INPUT is required", self.refuse("train", "--add-to", "./a.places", "--model",
                                                       "./a.places", status=2))
        self.assertIn("--limit", self.refuse("train", "first", "--add-to", "./a.places", "--model",
                                             "./a.places", "--forgetting", "0.5", status=2))

    def test_a_worse_model_does_not_replace_a_better_one(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.write_run("wrong/kitchen", rooms=("office",))
        (self.folder / "wrong/kitchen/office").rename(self.folder / "wrong/corridor")
        self.write_run("wrong", rooms=("office",))
        (self.folder / "wrong/kitchen").rmdir()
        figures = self.figures("train", "monday", "--model", "./home.places", "--validate", "tuesday",
                               *COLOUR)
        self.assertEqual(figures["validate_rate"], 1)
        before = (self.folder / "home.places").read_bytes()
        result = self.run_tool("train", "wrong", "--model", "./home.places", "--validate", "tuesday",
                               *COLOUR)
        self.assertEqual(result.returncode, 1)
        warning, complaint = self.without_progress(result.stderr)
        self.assertEqual(warning,
                         "warning: The runs show 'kitchen', which the model has not learned.")
        self.assertIn("The old model is kept: on the runs of --validate, ./home.places is right for 100.0 %",
                      complaint)
        self.assertEqual((self.folder / "home.places").read_bytes(), before)
        # Runs for validation keep their own labels.
        self.write_bag("judge.bag", [(room, room) for room in sorted(ROOMS) for _ in range(4)])
        self.write_bag("more.bag", [("kitchen", None)] * 4)
        figures = self.figures("train", "more.bag", "--label", "kitchen", "--add-to", "./home.places",
                               "--model", "./more.places", "--validate", "judge.bag")
        self.assertGreater(figures["validate_rate"], 0.9)
        self.write_run("wednesday", seed=2)
        text = self.succeed("train", "wednesday", "--add-to", "./home.places", "--model",
                            "./next.places", "--validate", "tuesday")
        self.assertIn("On the runs of --validate 100.0 % right", text)

    def test_the_kernel_and_the_machines_of_a_preset_can_be_set(self):
        self.write_run("monday")
        for change in ("svm.multiclass=one-against-one", "cues.crfh.kernel.type=gaussian",
                       "cues.crfh.kernel.type=intersection", "cues.crfh.kernel.type=linear",
                       "cues.crfh.kernel.type=polynomial", "cues.crfh.kernel.type=sigmoid"):
            with self.subTest(change=change):
                self.succeed("train", "monday", "--model", "./home.places", "--config", "crfh",
                             "--set", change)
                key, value = change.rsplit(".", 1)[1].split("=")
                self.assertIn(f"{key}: {value}", self.succeed("info", "./home.places"))

    def test_a_run_is_known_by_its_images_wherever_it_lies(self):
        train = ("train", "run", "--model", "./home.places", *COLOUR)
        self.write_run("run")
        self.succeed(*train)
        (self.folder / "run").rename(self.folder / "first")
        self.write_run("run", seed=1)
        self.write_run("more", seed=2)
        add = ("train", "more", "--add-to", "./home.places", "--model", "./more.places")
        self.assertEqual(self.figures(*add, "--validate", "run")["validate_rate"], 1)
        self.assertIn("./home.places was trained on first; give another run",
                      self.refuse(*add, "--validate", "first"))
        result = self.run_tool("calibrate", "first", "--model", "./home.places", "--out", "./c.places")
        self.assertIn("was trained on first", result.stderr)

    def test_a_copy_beside_a_run_counts_once(self):
        self.write_run("site/run")
        alone = self.figures("train", "site", "--model", "./home.places", *COLOUR)
        shutil.copytree(self.folder / "site/run", self.folder / "site/run.orig")
        both = self.figures("train", "site", "--model", "./home.places", *COLOUR)
        sentence = "site/run.orig: 24 of 24 images are those of site/run; they count once."
        self.assertEqual(both["warnings"], [sentence] + alone["warnings"])
        for key in ("images", "validation", "support_vectors", "gamma"):
            self.assertEqual(both[key], alone[key])
        self.write_run("next/run", seed=1)
        shutil.copytree(self.folder / "next/run", self.folder / "next/run.orig")
        self.assertEqual(self.figures("calibrate", "next", "--model", "./home.places")["images"], 24)

    def test_runs_that_begin_alike_are_not_taken_for_one(self):
        for seed, name in enumerate(("first", "second", "third")):
            self.write_run(name, seed=seed)
            for room in ROOMS:  # covered lenses
                self.write_image(f"{name}/{room}/000.png", np.zeros((96, 128, 3), np.uint8))
        figures = self.figures("train", "first", "--model", "./home.places", "--validate", "second",
                               *COLOUR)
        self.assertEqual(figures["validate_rate"], 1)
        self.figures("train", "second", "--add-to", "./home.places", "--model", "./home.places",
                     "--validate", "third")

    def test_a_learned_run_is_refused_before_the_training(self):
        for name, seed in (("first", 0), ("second", 1)):
            self.write_run(name, seed=seed)
            self.succeed("train", name, "--model", f"./{name}.places", *COLOUR)
        self.write_run("third", seed=2)
        self.succeed("train", "third", "--model", "./home.places", *COLOUR)
        self.write_run("empty", views=0)
        self.write_image("empty/kitchen/0.png", paint("kitchen", 0)).write_bytes(b"rubbish")
        for run in ("first", "second"):
            complaint = self.refuse("train", "empty", "--add-to", "./first.places", "--from-model",
                                    "./second.places", "--model", "./home.places", "--validate", run)
            self.assertIn(f"--validate: ./{run}.places was trained on {run}; give another run",
                          complaint)

    def test_it_names_what_cannot_be_used_to_validate(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        self.write_image("tuesday/attic/0.png", paint("kitchen", 0))
        self.write_image("tuesday/kitchen/8.png", paint("kitchen", 8)).write_bytes(b"rubbish")
        train = ("train", "monday", "--validate", "tuesday", "--model", "./home.places", *COLOUR)
        for _ in range(2):  # without and with a model to replace
            result = self.run_tool(*train, "--json", "-")
            self.assertEqual(result.returncode, 0, result.stderr)
            for words in ("The runs show 'attic', which", "8.png"):
                self.assertEqual(result.stderr.count(words), 1, result.stderr)
                self.assertTrue(any(words in warning for warning in
                                    json.loads(result.stdout)["warnings"]))

    def test_a_kernel_that_overflows_leaves_the_good_model_alone(self):
        self.write_run("monday")
        self.succeed("train", "monday", "--model", "./home.places", *COLOUR)
        before = (self.folder / "home.places").read_bytes()
        complaint = self.refuse("train", "monday", "--model", "./home.places", "--config",
                                "crfh", "--set", "cues.crfh.kernel.type=polynomial", "--set",
                                "cues.crfh.kernel.p=1e31", "--set", "cues.crfh.kernel.d=10")
        self.assertIn("cues.crfh.kernel.p", complaint)
        self.assertEqual((self.folder / "home.places").read_bytes(), before)

    def test_it_says_which_rooms_were_validated(self):
        self.write_run("monday")
        figures = self.figures("train", "monday", "--model", "./home.places", *COLOUR)
        self.assertEqual(figures["validation"]["rooms"], sorted(ROOMS))
        self.write_run("single", views=1)
        text = self.succeed("train", "single", "--model", "./single.places", *COLOUR)
        self.assertIn("Not validated", text)


if __name__ == "__main__":
    unittest.main()
