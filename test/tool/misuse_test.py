#!/usr/bin/env python3
"""Nothing that a user says is silently ignored, and no command destroys what it was given."""
import os
import shutil
import unittest

from tool_case import ROOMS, ToolCase, paint

COLOUR = ("--config", "crfh_colour", "--set", "reduction.method=none")
MODEL = ("--model", "./home.places")


class MisuseCase(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("monday")

    def train(self):
        self.succeed("train", "monday", *MODEL, *COLOUR)

    def write_labelled_bag(self, name):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        return self.write_bag(name, [(room, room) for room in ROOMS for _ in range(6)])

    def assert_usage(self, words, *arguments):
        line = self.refuse(*arguments, status=2)
        for word in words:
            self.assertIn(word, line)


class OptionsTest(MisuseCase):
    def test_options_for_bags_need_a_bag(self):
        self.train()
        picture = self.write_image("now.png", paint("office", 1))
        for option in (["--label", "kitchen"], ["--labels", "none.yaml"], ["--image-topic", "/a"],
                       ["--label-topic", "/b"]):
            for verb in (["train", "monday", "--model", "new"], ["evaluate", "monday", *MODEL],
                         ["info", "./home.places"], ["calibrate", "monday", *MODEL]):
                self.assert_usage([option[0], "bag"], *verb, *option)
        self.assert_usage(["--initial-label"], "info", "./home.places", "--initial-label", "office")
        self.assert_usage(["--image-topic"], "recognize", picture, *MODEL, "--image-topic", "/a")
        self.assert_usage(["--label"], "recognize", picture, *MODEL, "--label", "kitchen")

    def test_options_that_exclude_each_other(self):
        bag = self.write_labelled_bag("run.bag")
        for pair in (["--label", "a", "--labels", "f"], ["--label", "a", "--label-topic", "/t"],
                     ["--labels", "f", "--label-topic", "/t"]):
            self.assert_usage([pair[0], pair[2]], "train", bag, *MODEL, *pair)
        self.assert_usage(["--condition"], "import", "monday", "--out", "x.bag", "--condition",
                          "night")
        self.assert_usage(["--rate"], "import", "monday", "--out", "x.bag", "--rate", 9, "--layout",
                          "idol")
        self.assert_usage(["--every"], "experiment", "figures", "--out", "x", "--every", 2)
        self.assert_usage(["--layout"], "experiment", "materials", "--data", "monday", "--out", "x",
                          "--layout", "cold")
        self.assert_usage(["--max-dimensions"], "experiment", "bins", "--data", "monday", "--out",
                          "x", "--max-dimensions", 2)
        self.assert_usage(["twice"], "simulate", "--out", "x", "--conditions", "night,night")
        self.assert_usage(["svm.c", "twice"], "train", "monday", *MODEL, "--set", "svm.c=1", "--set",
                          "svm.c=2")
        self.assert_usage(["0..1024"], "train", "monday", *MODEL, "--threads", 100000)

    def test_models_that_cannot_be_joined_or_judged(self):
        self.train()
        for words, options in (
                (["--forgetting"], ["--limit", 0, "--forgetting", 0.5]),
                (["--validate", "monday"], ["--validate", self.folder / "monday"]),
                (["--from-model"], ["--from-model", "./home.places"])):
            self.assert_usage(words, "train", "monday", "--add-to", "./home.places", *MODEL,
                              *options)

        for verb in (["tune", "monday", "--out", "tuned.yaml"],
                     ["reduce", *MODEL, "--out", "./small.places", "--train", "monday"]):
            self.assert_usage(["--validate", "monday"], *verb, "--validate", "./monday")

    def test_no_model_is_judged_by_a_run_that_it_learned(self):
        self.train()
        shutil.copytree(self.folder / "monday", self.folder / "site/monday")
        self.write_run("site/tuesday", seed=1)
        for learned, judge in (("site", "site/monday"), ("site/monday", "site")):
            self.assert_usage(["--validate: " + judge], "train", learned, "--model",
                              "./new.places", "--validate", judge)
        line = self.refuse("train", "site/tuesday", *MODEL, "--validate", "./monday/")
        self.assertIn("./home.places was trained on ./monday", line)
        line = self.refuse("train", "site/tuesday", "--add-to", "./home.places", "--model",
                           "./new.places", "--validate", self.folder / "monday")
        self.assertIn("was trained on " + str(self.folder / "monday"), line)

    def test_no_model_is_judged_by_a_copy_of_what_it_learns(self):
        self.write_run("wednesday", seed=2)
        shutil.copytree(self.folder / "monday", self.folder / "copy")
        self.write_run("half", rooms=("kitchen", "office"))
        for judge in ("copy", "half"):
            for verb in (["train", "wednesday", "monday", "--model", "./new.places"],
                         ["tune", "wednesday", "monday", "--out", "tuned.yaml"]):
                line = self.refuse(*verb, "--validate", judge)
                self.assertIn(f": most images of {judge} are also learned; give another", line)

    def test_labels_do_not_apply_to_the_runs_to_validate_on(self):
        self.train()
        learned = self.write_labelled_bag("learned.bag")
        judge = self.write_labelled_bag("judge.bag")
        (self.folder / "wrong.yaml").write_text(
            "labels:\n- {from: 0, to: 9, place: office}\n- {from: 9, to: 18, place: kitchen}\n")
        reduce = ("reduce", *MODEL, "--out", "./small.places", "--share", 0.5, "--train", learned,
                  "--validate", judge)
        self.assertEqual(self.figures(*reduce, "--labels", "wrong.yaml")["validation"],
                         self.figures(*reduce)["validation"])

    def test_rooms_to_validate_on_that_are_not_learned(self):
        self.write_run("more", rooms=[*ROOMS])
        (self.folder / "more/office").rename(self.folder / "more/attic")
        line = self.refuse("tune", "monday", "--validate", "more", "--out", "tuned.yaml")
        self.assertIn("'attic'", line)

    def test_a_path_from_the_home_folder_after_an_equals_sign(self):
        self.extra_environment = {"HOME": str(self.folder)}
        self.succeed("train", "monday", "--model=~/of_mine.places", *COLOUR)
        self.assertTrue((self.folder / "of_mine.places").exists())


class FilesTest(MisuseCase):
    def test_an_output_is_no_other_file_of_the_command(self):
        (self.folder / "own.yaml").write_text("svm: {c: 10}\n")
        self.assert_usage(["--json", "--config", "own.yaml"], "train", "monday", *MODEL, "--config",
                          "own.yaml", "--json", self.folder / "own.yaml")
        self.assert_usage(["--json", "--out"], "tune", "monday", "--out", "tuned.yaml", "--json",
                          "./tuned.yaml")
        self.assertEqual((self.folder / "own.yaml").read_text(), "svm: {c: 10}\n")
        picture = self.write_image("now.png", paint("office", 1))
        self.assert_usage(["--json", "now.png"], "recognize", *MODEL, "--json", picture, picture)
        self.assert_usage(["--json", "--model"], "train", "monday", *MODEL, *COLOUR, "--json",
                          "home.places")
        model = "ros_home/place_recognition/models/home.places"  # of a name that is no path
        result = self.run_tool("train", "monday", "--model", "home", *COLOUR, "--json", model)
        self.assertEqual(result.returncode, 1)
        self.assertIn("not a text file", result.stderr)
        self.succeed("info", "home")

    def test_missing_folders_are_created(self):
        self.succeed("train", "monday", *MODEL, *COLOUR, "--json", "a/b/figures.json")
        self.succeed("import", "monday", "--out", "c/run.bag")
        self.succeed("evaluate", "c/run.bag", *MODEL, "--report", "d/e")
        for path in ("a/b/figures.json", "c/run.bag", "d/e/report.html"):
            self.assertTrue((self.folder / path).exists(), path)

    def test_links_in_a_circle(self):
        for name, target in (("a.places", "b.places"), ("b.places", "a.places")):
            (self.folder / name).symlink_to(target)
        self.assertIn("circle", self.refuse("train", "monday", "--model", "./a.places", *COLOUR))

    def test_what_killed_programs_leave_behind(self):
        ended = os.spawnlp(os.P_NOWAIT, "true", "true")
        os.waitpid(ended, 0)
        left = self.folder / f"runs/.night.tmp-{ended}"
        self.write_image(left / "cloister/1.png", paint("office", 1))
        self.write_run("runs/day")
        self.assertEqual(set(self.figures("train", "runs", *MODEL, *COLOUR)["rooms"]), set(ROOMS))
        self.succeed("simulate", "--out", "runs", "--conditions", "night", "--size", "32x24",
                     "--format", "images")
        self.assertFalse(left.exists())


class ModelNamesTest(MisuseCase):
    def test_a_model_that_was_meant_is_named(self):
        self.train()
        self.assertIn("home.places: No such file or directory; for the file in this folder, give "
                      "./home.places.", self.refuse("info", "home"))
        self.succeed("train", "monday", "--model", "mine", *COLOUR)
        for verb in (("info", "mines"), ("recognize", "monday", "--model", "mines"),
                     ("info", "./hone.places"), ("restore", "mines")):
            self.assertRegex(self.refuse(*verb), r"; did you mean (mine|./home.places)\?$")
        self.assertIn("check the name", self.refuse("info", "entirely_different"))


class InputsTest(MisuseCase):
    def test_bags_are_found_beside_images(self):
        self.write_labelled_bag("site/tuesday.bag")
        self.write_image("site/screenshots/1.png", paint("office", 1))
        result = self.run_tool("train", "site", *MODEL, *COLOUR)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Learned 3 places", result.stdout)
        self.assertRegex(result.stderr, "site/screenshots: .*beside bags, such as site/tuesday.bag")

    def test_labels_of_a_bag_with_dots_in_its_name(self):
        self.write_bag("run.v1.bag", [(room, None) for room in ROOMS])
        (self.folder / "run.labels.yml").write_text("labels: [{from: 0, place: attic}]\n")
        self.assertEqual(self.figures("info", "run.v1.bag")["labels"], [])
        (self.folder / "run.v1.labels.yml").write_text("labels: [{from: 0, place: hall}]\n")
        self.assertEqual(self.figures("info", "run.v1.bag")["labels"][0]["place"], "hall")

    def test_bags_that_lie_too_deep_are_named(self):
        self.write_labelled_bag("site/monday/a.bag")
        line = self.refuse("train", "site", *MODEL)
        self.assertIn("site/monday: it contains bags, such as site/monday/a.bag", line)

    def test_a_room_without_usable_images_is_the_reason(self):
        self.write_run("one", rooms=["office"])
        (self.folder / "one/attic").mkdir()
        (self.folder / "one/attic/1.png").write_bytes(b"\x89PNG\r\n\x1a\n cut off")
        line = self.refuse("train", "one", *MODEL)
        for word in ("'office'", "2 places", "one/attic/1.png"):
            self.assertIn(word, line)

    def test_the_folder_of_one_room_is_no_run(self):
        self.train()
        self.write_run(".", rooms=["office"])
        for verb in ("train", "evaluate"):
            options = ("--model", "./new.places") if verb == "train" else MODEL
            for given, above in (("monday/kitchen", "monday"), ("monday/kitchen/", "monday"),
                                 ("office", str(self.folder))):
                self.assertIn(f"has a label; if {given} is a room, give the folder above it, {above}, in "
                              "which the folders are the rooms.", self.refuse(verb, given, *options))

    def test_recognize_needs_no_labels_and_keeps_its_answers(self):
        self.train()
        bag = self.write_labelled_bag("run.bag")
        (self.folder / "run.labels.yaml").write_text("labels: nonsense\n")
        self.assertEqual(len(self.succeed("recognize", bag, *MODEL).splitlines()), 18)
        picture = self.write_image("now.png", paint("office", 1))
        result = self.run_tool("recognize", picture, "gone.png", *MODEL, "--json", "answers")
        self.assertEqual(result.returncode, 1)
        self.assertIn("gone.png", result.stderr)
        self.assertEqual((self.folder / "answers").read_text().count('"image"'), 1)

    def test_images_after_several_cameras(self):
        self.train()
        self.succeed("simulate", "--out", "drives", "--protocol", "drive", "--cameras",
                     "front,rear", "--conditions", "night", "--size", "64x48", "--rate", 0.3)
        lines = self.succeed("recognize", "drives/night.bag", "monday", *MODEL, "--image-topic",
                             "/front/image_raw,/rear/image_raw").splitlines()
        self.assertEqual(sum(line.startswith("monday/") for line in lines), 24)

    def test_calibration_on_what_was_learned_or_hardly_anything(self):
        self.train()
        result = self.run_tool("calibrate", "monday", *MODEL)
        self.assertIn("The model was trained on monday", result.stderr)
        self.write_run("few", views=1)
        self.assertIn("at least 5", self.refuse("calibrate", "few", *MODEL))

    def test_evaluation_on_what_was_learned(self):
        self.train()
        result = self.run_tool("evaluate", "monday", *MODEL)
        self.assertIn("The model was trained on monday", result.stderr)
        self.write_run("tuesday", seed=1)
        self.assertEqual(self.run_tool("evaluate", "tuesday", *MODEL).stderr, "")


if __name__ == "__main__":
    unittest.main()
