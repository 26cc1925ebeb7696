#!/usr/bin/env python3
"""What people run into: inputs of the kinds that public reports tell of, made here."""
import json
import os
import pathlib
import resource
import subprocess
import unicodedata
import unittest

import cv2
import numpy as np
import rosbag
import rospy
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import String
from tool_case import PLACE_TOOL, ROOMS, ToolCase, paint

MODEL = ("--model", "./home.places", "--config", "crfh_colour")
NOBODY = 65534


class FieldCase(ToolCase):
    def train(self, *inputs):
        """Learns; returns the figures and what was said on stderr."""
        result = self.run_tool("train", *inputs, *MODEL, "--json", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), result.stderr

    def rooms_of(self, *inputs):
        return sorted(self.train(*inputs)[0]["rooms"])

    def assert_names(self, text, *words):
        for word in words:
            self.assertIn(word, text)


class FolderTest(FieldCase):
    def test_what_came_along_is_passed_over_by_every_verb(self):
        self.write_run("parent/run", views=12)
        for path in ("__MACOSX/kitchen/._000.png", "__MACOSX/kitchen/000.png", "._run", ".DS_Store",
                     "run/.DS_Store", "run/kitchen/._000.png", "run/kitchen/Thumbs.db",
                     "run/@eaDir/kitchen/000.png", "run/.git/x.png", "run/lost+found/x.png"):
            target = self.folder / "parent" / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(b"\0\5\26\7")
        figures, said = self.train("parent")
        self.assertEqual(figures["images"], 12 * len(ROOMS))
        self.assertEqual(said.count("warning"), 0, said)
        self.assertEqual(self.figures("import", "parent/run", "--out", "run.bag")["images"],
                         12 * len(ROOMS))
        self.succeed("evaluate", "parent", *MODEL[:2])
        self.assertNotIn("cannot be used", self.succeed("recognize", "parent", *MODEL[:2]))

    def test_formats_that_opencv_reads_are_read(self):
        self.write_run("run", rooms=["office"])
        for view in range(8):
            ending = ("webp", "bmp", "tiff", "ppm", "jp2", "JPG", "JPEG", "TIF")[view]
            self.write_picture(f"run/kitchen/{view}.{ending}", paint("kitchen", view))
            self.write_picture(f"run/corridor/2024-05-{view + 10}/{view}.png", paint("corridor", view))
        figures, said = self.train("run")
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"corridor": 8, "kitchen": 8, "office": 8})
        self.assertNotIn("warning: Nothing", said)
        self.assertEqual(self.figures("import", "run", "--out", "run.bag")["images"], 24)

    def test_a_picture_beside_runs_does_not_make_rooms_of_them(self):
        for run in ("monday", "tuesday"):
            self.write_run(f"runs/{run}")
        self.write_picture("runs/map.png", paint("office", 1))
        self.assertEqual(self.rooms_of("runs"), sorted(ROOMS))
        self.assertEqual(self.rooms_of("runs/monday"), sorted(ROOMS))
        self.write_picture("runs/monday/map.png", paint("office", 1))
        figures, said = self.train("runs/monday")
        self.assertEqual(sorted(figures["rooms"]), sorted(ROOMS))
        self.assertIn("1 picture without label", said)

    def test_folders_that_give_nothing_are_named(self):
        self.write_run("run")
        (self.folder / "run/attic").mkdir()
        (self.folder / "run/attic/IMG_1.HEIC").write_bytes(b"\0\0\0\x18ftypheic")
        (self.folder / "run/cellar").mkdir()
        (self.folder / "run/loft").mkdir()
        (self.folder / "run/loft/1.jpg").write_bytes(b"")
        for said in (self.train("run")[1],
                     self.run_tool("import", "run", "--out", "run.bag").stderr):
            self.assert_names(said, "run/attic: it holds 1 .heic file", "run/cellar: it is empty",
                              "run/loft/1.jpg: it is empty")
        self.assert_names(self.train("run")[1],
                          "'loft' is not learned: its 1 picture cannot be used (run/loft/1.jpg: it")
        self.assert_names(self.run_tool("import", "run", "--out", "run2.bag").stderr,
                          "'loft' is not in the bag: its pictures cannot be used (run/loft/1.jpg")

    def test_a_model_of_any_name_is_told_from_other_files(self):
        self.write_run("run")
        self.succeed("train", "run", "--model", "./plain", "--config", "crfh_colour")
        self.assertIn("kitchen", self.succeed("info", "./plain"))
        (self.folder / "notes.txt").write_text("notes")
        self.assertIn("neither a bag nor a model", self.refuse("info", "notes.txt"))

    def test_rooms_that_are_links(self):
        self.write_run("store")
        (self.folder / "run").mkdir()
        for room in ROOMS:
            (self.folder / "run" / room).symlink_to(self.folder / "store" / room)
        (self.folder / "run/old").symlink_to("gone")
        (self.folder / "run/kitchen/again").symlink_to(self.folder / "run")
        self.assertEqual(self.rooms_of("run"), sorted(ROOMS))
        figures = self.figures("import", "run", "--out", "run.bag")
        self.assertEqual((figures["images"], figures["places"]), (24, sorted(ROOMS)))
        self.assert_names(" ".join(figures["warnings"]), "run/old", "leads nowhere")

    @unittest.skipUnless(os.geteuid() == 0, "to become somebody without rights")
    def test_a_folder_that_may_not_be_read(self):
        self.write_run("runs/run")
        for folder in ("runs/run/attic", "runs/backup", "runs/lost+found"):
            (self.folder / folder).mkdir()
            (self.folder / folder).chmod(0)
        self.folder.chmod(0o777)
        result = subprocess.run(
            [PLACE_TOOL, "train", "runs", *MODEL], cwd=self.folder, text=True, capture_output=True,
            env=self.environment(), timeout=120, preexec_fn=lambda: os.setuid(NOBODY))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_names(result.stderr, "runs/run/attic", "runs/backup", "Permission denied")
        self.assertNotIn("lost+found", result.stderr)

    def test_two_names_of_one_room(self):
        names = [unicodedata.normalize(form, "Küche") for form in ("NFC", "NFD")]
        for i, name in enumerate([*names, names[0] + " ", "Kü\u200bche", "\u00adK\u200eüche"]):
            for view in range(4):
                self.write_picture(f"run/{name}/{view}.png", paint("kitchen", 4 * i + view))
        for i, name in enumerate(("Office_A", "office_a")):
            for view in range(4):
                self.write_picture(f"run/{name}/{view}.png", paint("office", 4 * i + view))
        figures, said = self.train("run")
        self.assertEqual(sorted(figures["rooms"]), sorted([names[0], "Office_A", "office_a"]))
        self.assertEqual(figures["rooms"][names[0]]["count"], 20)
        self.assert_names(said, "'Office_A' and 'office_a' differ in upper and lower case only")


class BagTest(FieldCase):
    def write_labelled(self, name, start, frames, labels, topic="/place_label"):
        """JPEG frames of a room a second from `start`; labels: (second, text)."""
        with rosbag.Bag(str(self.folder / name), "w") as bag:
            for second, text in labels:
                bag.write(topic, String(text), rospy.Time(start + second))
            for i, room in enumerate(frames):
                stamp = rospy.Time(start + i)
                image = CompressedImage(format="bgr8; jpeg compressed bgr8")
                image.header.stamp = stamp
                image.data = cv2.imencode(".jpg", paint(room, start % 100 + i))[1].tobytes()
                bag.write("/camera/image_raw/compressed", image, stamp)
        return name

    def test_labels_of_a_split_recording_hold_in_its_next_part(self):
        self.write_labelled("run_0.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                            [(0, "kitchen"), (5, "office")])
        self.write_labelled("run_1.bag", 1010, ["office"] * 6, [])
        self.write_labelled("run_2.bag", 1016, ["office"] * 3 + ["corridor"] * 6, [(3, "corridor")])
        self.write_labelled("late.bag", 5000, ["office"] * 6, [])
        figures, said = self.train("run_0.bag", "run_1.bag", "run_2.bag", "late.bag")
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"kitchen": 5, "office": 14, "corridor": 6})
        self.assert_names(said, "run_1.bag goes on where run_0.bag ends, and starts in 'office'",
                          "late.bag has no labels", "--repeat-latched")
        figures, said = self.train("run_2.bag", "run_1.bag", "run_0.bag")  # in any order
        self.assertEqual(figures["rooms"]["office"]["count"], 14)
        self.assertNotIn("warning: run_", said)
        self.assert_names(self.train("run_2.bag", "run_0.bag")[1],
                          "run_2.bag starts without a label", "--repeat-latched")
        self.assert_names(self.run_tool("train", "run_1.bag", *MODEL).stderr,
                          "run_1.bag has no labels", "--repeat-latched")
        (self.folder / "late.bag").unlink()
        self.assertEqual(self.train(".")[0]["images"], 25)

    def test_an_image_that_cannot_be_used_does_not_stop_recognition(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 5 + ["office"] * 5,
                            [(0, "kitchen"), (5, "office")])
        self.train("run.bag")
        with rosbag.Bag(str(self.folder / "run.bag"), "a") as bag:
            bag.write("/camera/image_raw/compressed", CompressedImage(format="jpeg"),
                      rospy.Time(1011))
            self.write_picture("cut.jpg", paint("kitchen", 1))
            cut = CompressedImage(format="jpeg", data=(self.folder / "cut.jpg").read_bytes()[:1500])
            bag.write("/camera/image_raw/compressed", cut, rospy.Time(1012))
        result = self.run_tool("recognize", "run.bag", *MODEL[:2], "--json", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        answers = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual(len(answers), 12)
        self.assertIn("empty", answers[10]["reason"])
        self.assertIn("cut short", answers[11]["reason"])
        self.assertEqual((answers[11]["known"], answers[11]["place"]), (False, ""))
        self.assert_names(result.stderr, "2 pictures cannot be used")
        for verb in ("train", "evaluate"):
            self.assert_names(self.run_tool(verb, "run.bag", *(MODEL if verb == "train" else
                                                              MODEL[:2])).stderr, "empty")

    def test_labels_with_commas_are_labels(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 5 + ["office"] * 5, [])
        (self.folder / "labels.dat").write_text("stamp,label\n1000.0,kitchen\n1004.5,office\n")
        figures, said = self.train("run.bag")
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"kitchen": 5, "office": 5})
        self.assertIn("separated by commas", said)

    def test_a_bag_of_a_recorder_that_was_killed(self):
        self.write_labelled("whole.bag", 1000, ["kitchen"] * 3, [(0, "kitchen")])
        with open(self.folder / "whole.bag", "rb") as file:
            content = bytearray(file.read())
        field = content.index(b"index_pos=") + 10
        content[field:field + 8] = bytes(8)
        (self.folder / "monday.bag.active").write_bytes(content)
        for verb in (("info", "monday.bag.active"), ("train", "monday.bag.active", *MODEL)):
            self.assert_names(self.refuse(*verb), "rosbag reindex monday.bag.active",
                              "rename it to monday.bag")
        (self.folder / "runs").mkdir()
        self.write_labelled("runs/sound.bag", 1000, ["kitchen"] * 4 + ["office"] * 4,
                            [(0, "kitchen"), (4, "office")])
        (self.folder / "runs/monday.bag.active").write_bytes(content)
        self.assert_names(self.train("runs")[1], "rosbag reindex runs/monday.bag.active",
                          "rename it to runs/monday.bag")

    def test_a_whole_bag_that_is_named_as_if_it_were_being_recorded(self):
        self.write_labelled("run.bag", 1000, ["kitchen"] * 4 + ["office"] * 4,
                            [(0, "kitchen"), (4, "office")])
        (self.folder / "run.bag").rename(self.folder / "run.bag.active")
        figures, said = self.train("run.bag.active")
        self.assertEqual(figures["images"], 8)
        self.assert_names(said, "run.bag.active is whole", "rename it")
        self.assert_names(self.run_tool("info", "run.bag.active").stderr, "rename it")

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
        self.folder.chmod(0o777)
        result = subprocess.run(
            [PLACE_TOOL, "info", "run.bag"], cwd=self.folder, text=True, capture_output=True,
            env=self.environment(), timeout=120, preexec_fn=lambda: os.setuid(NOBODY))
        self.assertEqual(result.returncode, 1)
        self.assert_names(result.stderr, "run.bag", "Permission denied")


class FullDiskTest(FieldCase):
    """A limit on the size of files stands for a disk that is full: the kernel refuses to write."""

    def refuse_within(self, kilobytes, *arguments):
        before = self.files()
        limit = kilobytes * 1024
        result = subprocess.run(
            [PLACE_TOOL, *arguments], cwd=self.folder, text=True, capture_output=True, timeout=120,
            env=self.environment(),
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(result.returncode, 1, result.stderr)
        lines = [line for line in result.stderr.splitlines() if not line.endswith(" %")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assert_names(lines[0], "Cannot write", "make room")
        self.assertEqual(self.files(), before)

    def test_every_writer_of_bags_and_pictures(self):
        self.write_run("run", views=12)
        (self.folder / "out").mkdir()
        for kilobytes in (0, 1, 8, 40):
            self.refuse_within(kilobytes, "import", "run", "--out", "run.bag")
            self.refuse_within(kilobytes, "import", "run", "--out", "run.bag", "--raw")
        simulate = ("simulate", "--out", "out", "--size", "96x72", "--conditions", "night")
        self.refuse_within(8, *simulate)
        self.refuse_within(1, *simulate, "--format", "images")

    def test_every_writer_of_other_files(self):
        self.write_run("run")
        self.refuse_within(1, "train", "run", *MODEL)
        self.succeed("train", "run", *MODEL)
        self.refuse_within(0, "recognize", "run", *MODEL[:2], "--json", "answers")

    def test_standard_output(self):
        self.write_run("run")
        self.succeed("train", "run", *MODEL)
        for arguments in (("recognize", "run", *MODEL[:2]), ("info", "./home.places"),
                          ("info", "./home.places", "--json", "-")):
            with open("/dev/full", "w") as full:
                result = subprocess.run([PLACE_TOOL, *arguments], cwd=self.folder, text=True,
                                        stdout=full, stderr=subprocess.PIPE, timeout=120,
                                        env=self.environment())
            self.assertEqual(result.returncode, 1, arguments)
            self.assert_names(result.stderr, "standard output")

    def test_devices_are_written_to_and_stay(self):
        self.write_run("run")
        self.succeed("train", "run", *MODEL)
        line = self.run_tool("recognize", "run", *MODEL[:2], "--json", "/dev/full").stderr
        self.assert_names(line, "Cannot write /dev/full")
        self.assertTrue(pathlib.Path("/dev/full").is_char_device())
        self.succeed("recognize", "run", *MODEL[:2], "--json", "/dev/null")
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())
        self.refuse("import", "run", "--out", "/dev/full")


class InfraredTest(FieldCase):
    """Images of 10 bits in 16."""

    def write_infrared(self, name, rooms, brightness, bits=10):
        """mono16 images a second from 1000, `brightness` of 0..255 times the paint; of 8 bits mono8."""
        with rosbag.Bag(str(self.folder / name), "w") as bag:
            for i, room in enumerate(rooms):
                grey = cv2.cvtColor(paint(room, i), cv2.COLOR_BGR2GRAY).astype(np.float64)
                levels = np.minimum(grey * brightness * 4, 1023).astype("<u2")
                stamp = rospy.Time(1000 + i)
                if i % 4 == 0:
                    bag.write("/place_label", String(room), stamp)
                image = Image(height=96, width=128, encoding="mono16", step=256)
                image.data = levels.tobytes()
                if bits == 8:
                    image.encoding, image.step = "mono8", 128
                    image.data = (levels >> 2).astype(np.uint8).tobytes()
                image.header.stamp = stamp
                bag.write("/infra", image, stamp)
        return name

    def answers(self, *inputs):
        result = self.run_tool("recognize", "--model", "./home.places", *inputs, "--json", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        return [(line["place"], line["scores"]) for line in
                map(json.loads, result.stdout.splitlines())], result.stderr

    def test_the_range_that_was_learned_is_kept(self):
        rooms = [room for room in ("kitchen", "corridor", "office") for _ in range(8)]
        self.write_infrared("day.bag", rooms, 1.2)
        figures, said = self.train("day.bag")
        self.assert_names(said, "0 .. 1023 of 16 bits")
        self.assertLess(500, json.loads(self.succeed("info", "./home.places", "--json", "-"))
                        ["image_depth"][1])
        # By itself this run would be taken for one of 9 bits.
        dark, said = self.answers(self.write_infrared("dark.bag", rooms, .4))
        self.assert_names(said, "0 .. 1023 of 16 bits, as in training")
        self.assertEqual(dark, self.answers(self.write_infrared("dark8.bag", rooms, .4, bits=8))[0])
        for verb in ("evaluate", "calibrate"):
            result = self.run_tool(verb, "dark.bag", "--model", "./home.places")
            self.assertIn("as in training", result.stderr)
        # A single picture, and a folder.
        dark_grey = (cv2.cvtColor(paint("kitchen", 0), cv2.COLOR_BGR2GRAY) * 1.6).astype(np.uint16)
        picture = self.write_picture("runs/kitchen/0.png", dark_grey)
        single = self.answers(picture)[0]
        self.assertEqual(single, self.answers("runs")[0])
        self.assertEqual(single, self.answers(self.write_picture(
            "eight.png", (dark_grey >> 2).astype(np.uint8)))[0])

    def test_runs_of_one_training_share_a_range(self):
        rooms = [room for room in ("kitchen", "corridor", "office") for _ in range(8)]
        self.write_infrared("dark.bag", rooms, .4)
        self.write_infrared("day.bag", rooms, 1.2)
        said = self.train("dark.bag", "day.bag")[1]
        self.assertEqual(said.count("0 .. 1023 of 16 bits"), 2, said)


class RedAndBlueTest(FieldCase):
    def test_compressed_images_are_those_that_image_transport_makes_of_them(self):
        """The same images raw, and compressed without loss in each way of naming the channels."""
        ways = {"raw": None, "rgb8; png compressed rgb8": False, "rgb8; png compressed bgr8": True,
                "bgr8; png compressed bgr8": True, "bgr8; png compressed rgb8": False,
                "rgb8; png compressed ": False, "png": True}
        models = {}
        for way, stored_as_bgr in ways.items():
            with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
                for i in range(24):
                    stamp, room = rospy.Time(1000 + i), list(ROOMS)[i // 8]
                    bgr = paint(room, i)
                    if i % 8 == 0:
                        bag.write("/place_label", String(room), stamp)
                    if way == "raw":
                        image = Image(height=96, width=128, encoding="rgb8", step=384,
                                      data=bgr[..., ::-1].tobytes())
                    else:
                        stored = bgr if stored_as_bgr else bgr[..., ::-1]
                        image = CompressedImage(format=way, data=cv2.imencode(
                            ".png", np.ascontiguousarray(stored))[1].tobytes())
                    image.header.stamp = stamp
                    bag.write("/image" if way == "raw" else "/image/compressed", image, stamp)
            self.train("run.bag")
            models[way] = (self.folder / "home.places").read_bytes()
        for way, model in models.items():
            self.assertTrue(model == models["raw"], way)


class SurroundingsTest(FieldCase):
    def train_in(self, **environment):
        result = subprocess.run(
            [PLACE_TOOL, "train", "run", *MODEL, "--json", "-"], cwd=self.folder, timeout=120,
            env={key: value for key, value in dict(self.environment(), **environment).items()
                 if value is not None}, text=True, capture_output=True)
        return result

    def test_a_locale_with_a_decimal_comma(self):
        made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8",
                               str(self.folder / "de_DE.UTF-8")], capture_output=True)
        if made.returncode > 1:
            self.skipTest("no source of the locale de_DE (package locales)")
        self.write_run("run")
        plain = self.train_in(LC_ALL="C")
        model = (self.folder / "home.places").read_bytes()
        german = self.train_in(LC_ALL="de_DE.UTF-8", LOCPATH=str(self.folder))
        figures = [json.loads(result.stdout) for result in (plain, german)]
        for figure in figures:
            figure.pop("seconds", None)
        self.assertEqual(*figures)
        self.assertTrue((self.folder / "home.places").read_bytes() == model)

    def test_no_home(self):
        self.write_run("run")
        result = self.train_in(HOME=None, ROS_HOME=None)
        self.assertEqual(result.returncode, 0, result.stderr)
        environment = {key: value for key, value in os.environ.items()
                       if key not in ("HOME", "ROS_HOME")}
        result = subprocess.run([PLACE_TOOL, "train", "run", "--model", "home"], cwd=self.folder,
                                env=environment, text=True, capture_output=True, timeout=120)
        self.assertEqual(result.returncode, 1)
        self.assert_names(result.stderr, "HOME is not set; set ROS_HOME or HOME.")

    def test_names_in_any_script(self):
        names = ["\U0001f373 kitchen", "\U0001f469\u200d\U0001f373", "\u5eca\u4e0b", "\u063a\u0631\u0641\u0629"]
        for i, name in enumerate(names):
            for view in range(8):
                self.write_picture(f"\u2615 run/{name}/{view}.png",
                                   paint(list(ROOMS)[i % 3], 8 * i + view, seed=i))
        self.assertEqual(self.rooms_of("\u2615 run"), sorted(names))
        figures = self.figures("evaluate", "\u2615 run", "--model", "./home.places", "--report",
                               "report \u2615")
        self.assertEqual(sorted(figures["confusion"]["labels"]), sorted(names))
        self.succeed("import", "\u2615 run", "--out", "\u2615.bag")
        self.assertEqual(self.rooms_of("\u2615.bag"), sorted(names))
        for name in names:
            self.assertIn(name, self.succeed("info", "./home.places"))


class SharedCasesTest(FieldCase):
    """The inputs of the reports themselves, where the folder is."""

    def setUp(self):
        super().setUp()
        self.cases = pathlib.Path(os.environ.get("PLACE_RECOGNITION_TEST_DATA", "")).parent / "cases"
        if not self.cases.is_dir():
            self.skipTest(f"no {self.cases}")

    def test_rooms(self):
        three = ["corridor", "kitchen", "office_a"]
        for case in ("base.bag", "csvlabels/run.bag", "bom/run.bag", "header/run.bag",
                     "noslash/run.bag", "trunc/run.bag", "mac/run", "mac/parent",
                     "zerotime/run.bag", "rgbjpg/compressed.bag", "cdepth.bag"):
            with self.subTest(case):
                figures, said = self.train(self.cases / case)
                self.assertEqual(sorted(figures["rooms"]), three)
                if case == "trunc/run.bag":
                    self.assertEqual((figures["images"], figures["skipped_images"]), (48, 24))
                elif case not in ("zerotime/run.bag",):
                    self.assertEqual(figures["skipped_images"], 0, said)

    def test_five_rooms_of_several_formats(self):
        figures, said = self.train(self.cases / "webp/run")
        self.assertEqual(len(figures["rooms"]), 5, said)

    def test_trailing_blanks(self):
        figures, said = self.train(self.cases / "trailing.bag", self.cases / "base.bag")
        self.assertEqual(sorted(figures["rooms"]), ["Office_A", "corridor", "kitchen", "office_a"])
        self.assertIn("differ in upper and lower case only", said)

    def test_split(self):
        figures, said = self.train(self.cases / "split/run_0.bag", self.cases / "split/run_1.bag")
        self.assertEqual(figures["skipped_images"], 0, said)

    def test_an_empty_frame(self):
        self.train(self.cases / "base.bag")
        result = self.run_tool("recognize", self.cases / "emptyframe.bag", *MODEL[:2])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("1 picture cannot be used", result.stderr)


if __name__ == "__main__":
    unittest.main()
