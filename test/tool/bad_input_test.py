#!/usr/bin/env python3
"""Bad input yields one line with the problem, its place and the remedy, and leaves no files."""
import unittest

from tool_case import ROOMS, ToolCase, paint

MODEL = ("--model", "./home.places")


class BadInputTest(ToolCase):
    def assert_fails(self, words, *arguments):
        line = self.refuse(*arguments)
        for word in words:
            self.assertIn(word, line)
        self.assertRegex(line, r"[;,:].*\w", "says what to do")

    def test_missing_input(self):
        self.assert_fails(["nowhere.bag", "check"], "train", "nowhere.bag", *MODEL)
        self.assert_fails(["nowhere", "check"], "train", "nowhere", *MODEL)

    def test_input_that_is_not_a_run(self):
        (self.folder / "notes.txt").write_text("hello")
        self.assert_fails(["notes.txt", "bag"], "train", "notes.txt", *MODEL)

    def test_empty_folder(self):
        (self.folder / "empty").mkdir()
        self.assert_fails(["empty", "room"], "train", "empty", *MODEL)

    def test_bag_without_images(self):
        self.write_bag("mute.bag", [(None, "kitchen"), (None, "office")])
        self.assert_fails(["mute.bag", "image"], "train", "mute.bag", *MODEL)

    def test_bag_without_labels(self):
        self.write_bag("plain.bag", [("kitchen", None), ("office", None)])
        self.assert_fails(["plain.bag", "label"], "train", "plain.bag", *MODEL)

    def test_single_room(self):
        self.write_bag("one.bag", [("kitchen", "kitchen")] * 6)
        self.assert_fails(["kitchen"], "train", "one.bag", *MODEL)
        self.write_run("one", rooms=["office"])
        self.assert_fails(["office"], "train", "one", *MODEL)

    def test_file_that_is_not_a_bag(self):
        (self.folder / "fake.bag").write_bytes(b"#ROSBAG V2.0\nrubbish")
        self.assert_fails(["fake.bag"], "train", "fake.bag", *MODEL)
        self.assert_fails(["fake.bag"], "info", "fake.bag")

    def test_labels_for_several_bags(self):
        for name in ("a.bag", "b.bag"):
            self.write_bag(name, [(room, None) for room in ROOMS])
        (self.folder / "labels.dat").write_text("1000 kitchen\n")
        self.assert_fails(["--labels"], "train", "a.bag", "b.bag", "--labels", "labels.dat", *MODEL)

    def test_unwritable_output_is_told_before_the_work(self):
        self.write_run("monday")
        (self.folder / "file").write_text("")
        self.assert_fails(["file/home.places"], "train", "monday", "--model", "file/home.places")
        self.assert_fails(["run.bag"], "import", "monday", "--out", "file/run.bag")
        self.assert_fails(["file"], "simulate", "--out", "file/runs", "--size", "32x24")

    def test_an_output_replaces_only_a_file_of_its_kind(self):
        self.write_run("monday")
        images = [self.write_image(name, paint("kitchen", 1)) for name in ("1.jpg", "2.png")]
        bag = self.folder / self.write_bag("run.bag", [(room, room) for room in ROOMS] * 6)
        files = [*images, bag, self.folder / "empty", self.folder / "text"]
        files[-2].touch()
        files[-1].write_text("kitchen\n")
        other = self.write_image("3.png", paint("kitchen", 2))
        before = [path.read_bytes() for path in files]
        for path in images + [bag]:
            for arguments in (["recognize", *MODEL, "--json", path, other],
                              ["tune", "monday", "--out", path],
                              ["train", "monday", "--model", path]):
                self.assert_fails([str(path), "another name"], *arguments)
        for path in images + [files[-1]]:
            self.assert_fails([str(path), "another name"], "import", "monday", "--out", path)
        self.assertEqual([path.read_bytes() for path in files], before)
        self.succeed("import", "monday", "--out", bag)
        for path in files[-2:]:
            self.succeed("info", bag, "--json", path)
            self.assertTrue(path.read_text().startswith("{"))

    def test_an_existing_folder_is_not_rendered_into(self):
        self.write_run("runs/night")
        self.assert_fails(["runs/night"], "simulate", "--out", "runs", "--conditions", "night",
                          "--format", "images", "--size", "32x24")

    def test_options_out_of_range(self):
        self.assert_fails(["rate"], "simulate", "--out", "runs", "--rate", "-1")

    def test_features_of_an_image_that_has_none(self):
        self.write_image("tiny.png", paint("kitchen", 0)[:8, :8])
        self.assert_fails(["tiny.png"], "features", "tiny.png")


class BadInputToModelTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("monday")
        self.succeed("train", "monday", *MODEL, "--config", "crfh_colour")
        self.picture = self.write_image("now.png", paint("kitchen", 1))

    def assert_fails(self, words, *arguments):
        line = self.refuse(*arguments)
        for word in words:
            self.assertIn(word, line)

    def test_missing_model(self):
        for verb in (("recognize", self.picture), ("evaluate", "monday")):
            self.assert_fails(["absent"], *verb, "--model", "absent")
        self.assert_fails(["absent"], "info", "absent")
        self.assert_fails(["absent"], "reduce", "--model", "absent", "--out", "small")

    def test_a_bag_is_suggested_for_its_name_without_the_ending(self):
        (self.folder / "d1").mkdir()
        for bag in ("tuesday.bag", "d1/cloudy.bag", "killed.bag"):
            self.write_bag(bag, [("kitchen", "kitchen")] * 3)
        (self.folder / "killed.bag").rename(self.folder / "killed.bag.active")
        for name, words in (("tuesday", "; give tuesday.bag, which lies beside it."),
                            ("d1/cloudy", "; give d1/cloudy.bag, which lies beside it."),
                            ("killed", "; killed.bag.active lies beside it: it is being recorded"),
                            ("killed.bag", "; killed.bag.active lies beside it: it is being")):
            for arguments in (("info", name), ("train", name, *MODEL), ("label", name),
                              ("recognize", name, *MODEL), ("evaluate", name, *MODEL)):
                self.assert_fails([name, words], *arguments)
        (self.folder / "d1/cloudy").mkdir()
        self.assert_fails(["d1/cloudy is a folder; give d1/cloudy.bag, which"], "info", "d1/cloudy")
        self.succeed("train", "monday", "--model", "tuesday", "--config", "crfh_colour")
        self.assertIn("model", self.succeed("info", "tuesday"))

    def test_a_bag_is_no_model(self):
        self.write_bag("tuesday.bag", [("kitchen", "kitchen")] * 3)
        for bag in ("tuesday.bag", "./tuesday.bag", "lost.bag", "killed.bag.active"):
            self.assert_fails([bag + "' is a bag, not a model; give the name of a model"],
                              "evaluate", "monday", "--model", bag)

    def test_damaged_model(self):
        whole = (self.folder / "home.places").read_bytes()
        for damaged in (whole[:-1], whole[:40], b"", whole[:60] + b"x" + whole[61:], b"PNG" * 99):
            (self.folder / "home.places").write_bytes(damaged)
            self.assert_fails(["home.places"], "recognize", self.picture, *MODEL)

    def test_invalid_model_name(self):
        self.assert_fails(["a b"], "recognize", self.picture, "--model", "a b")

    def test_images_that_cannot_be_decoded(self):
        whole = self.picture.read_bytes()
        for content in (b"", b"no image", whole[:60], whole[:-9], whole[:200] + b"?" + whole[201:]):
            (self.folder / "bad.png").write_bytes(content)
            self.assert_fails(["bad.png"], "recognize", "bad.png", *MODEL)
            self.assert_fails(["bad.png"], "features", "bad.png")
        self.assert_fails(["absent.png"], "recognize", "absent.png", *MODEL)

    def test_damaged_image_among_good_ones_is_skipped_in_training(self):
        (self.folder / "monday/kitchen/007.png").write_bytes(b"no image")
        result = self.run_tool("train", "monday", "--model", "./b.places", "--json", "figures")
        self.assertEqual(result.returncode, 0)
        self.assertIn("warning", result.stderr)
        self.assertIn("007.png", result.stderr)

    def test_label_never_seen(self):
        self.write_bag("attic.bag", [("kitchen", "attic")] * 3)
        self.assert_fails(["attic"], "evaluate", "attic.bag", *MODEL)
        self.assert_fails(["attic"], "reduce", *MODEL, "--out", "./s.places", "--max-loss", "1",
                          "--validate", "attic.bag")

    def test_evaluation_without_labels(self):
        self.write_bag("plain.bag", [("kitchen", None)] * 3)
        self.assert_fails(["plain.bag", "label"], "evaluate", "plain.bag", *MODEL)


class BadUsageTest(ToolCase):
    def test_status_two_and_one_line(self):
        for arguments in (("train",), ("train", "a.bag"), ("train", "a.bag", "--modle", "m"),
                          ("recognize", "--model", "m"), ("reduce", "--model", "m"),
                          ("reduce", "--model", "m", "--out", "n", "--max-loss", "1"),
                          ("reduce", "--model", "m", "--out", "n", "--tau", "1",
                           "--support-vectors", "3"),
                          ("simulate", "--out", "runs", "--size", "large"),
                          ("simulate", "--out", "runs", "--conditions", "foggy"),
                          ("import", "data", "--out", "a.bag", "--layout", "heap"),
                          ("features", "a.png", "b.png")):
            self.refuse(*arguments, status=2)

    def test_a_misspelt_option_or_verb_is_told_with_the_one_meant(self):
        self.assertIn("--model?", self.refuse("train", "a.bag", "--modle", "m", status=2))
        result = self.run_tool("trian", "a.bag", "--model", "m")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^place_tool: .*trian.*train\?.*--help\.\n$")

    def test_no_verb(self):
        result = self.run_tool()
        self.assertEqual(result.returncode, 2)
        self.assertEqual(len(result.stderr.splitlines()), 1)

    def test_every_verb_has_help_with_an_example(self):
        verbs = ("simulate", "import", "train", "recognize", "evaluate", "reduce", "features",
                 "info", "restore")
        for verb in verbs:
            self.assertIn(f"Example:\n  place_tool {verb} ", self.succeed(verb, "--help"))
        for verb in verbs:
            self.assertIn(verb, self.succeed("--help"))


if __name__ == "__main__":
    unittest.main()
