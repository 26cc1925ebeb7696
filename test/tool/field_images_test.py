#!/usr/bin/env python3
"""Images of several sizes, 10-bit images, and images with other orders of channels."""
import json
import unittest

import cv2
import numpy as np
import rosbag
import rospy
from field_case import FieldCase
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import String
from tool_case import ROOMS, paint


class SizesTest(FieldCase):
    def resize(self, path, width, height):
        image = cv2.imread(str(self.folder / path))
        self.write_image(path, cv2.resize(image, (width, height)))

    def test_most_images_decide_the_size(self):
        self.write_run("run")
        self.resize("run/corridor/000.png", 16, 12)  # the first image
        said = self.train("run")[1]
        self.assertIn("run: 1 of 24 images has another size than the usual 128 x 96: "
                      "run/corridor/000.png, 16 x 12.", said)
        self.assertEqual(self.figures("info", "./home.places")["image_size"], [128, 96])
        self.resize("run/office/003.png", 64, 48)
        self.assertIn("run: 2 of 24 images have another size than the usual 128 x 96 (such as "
                      "run/corridor/000.png, 16 x 12).", self.train("run")[1])

    def test_a_folder_has_no_camera_to_set(self):
        self.write_run("run")
        self.resize("run/corridor/000.png", 128, 64)
        self.resize("run/corridor/001.png", 64, 48)
        said = self.train("run")[1]
        self.assert_names(said, "run: Images of 128 x 64 have another aspect ratio than the 128 x 96 that are "
                          "learned; crop them to that ratio, or leave them out.",
                          "run: Images of 64 x 48 are enlarged to 128 x 96, the size that is learned, and lack "
                          "its finest detail; leave them out, or train with image.max_width=64.")
        self.assertNotIn("camera", said)

    def test_images_that_the_camera_turned(self):
        self.write_run("run")
        for path in sorted((self.folder / "run").glob("*/*.png")):
            picture = cv2.imencode(".jpg", cv2.imread(str(path)))[1].tobytes()
            turned = (b"\xff\xe1\0\x22Exif\0\0MM\0*\0\0\0\x08\0\x01"
                      b"\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0")
            path.with_suffix(".jpg").write_bytes(picture[:2] + turned + picture[2:])
            path.unlink()
        self.train("run")
        self.assertEqual(self.figures("info", "./home.places")["image_size"], [96, 128])


class InfraredTest(FieldCase):
    """10-bit images in 16 bits."""

    def write_infrared(self, name, rooms, brightness, bits=10):
        """Writes mono16 or mono8 images, one per second from 1000 s, dimmed by `brightness`."""
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
        # On its own, this run would be taken for a 9-bit one.
        dark, said = self.answers(self.write_infrared("dark.bag", rooms, .4))
        self.assert_names(said, "0 .. 1023 of 16 bits, as in training")
        self.assertEqual(dark, self.answers(self.write_infrared("dark8.bag", rooms, .4, bits=8))[0])
        for verb in ("evaluate", "calibrate"):
            result = self.run_tool(verb, "dark.bag", "--model", "./home.places")
            self.assertIn("as in training", result.stderr)
        # A single image, and a folder.
        dark_grey = (cv2.cvtColor(paint("kitchen", 0), cv2.COLOR_BGR2GRAY) * 1.6).astype(np.uint16)
        picture = self.write_image("runs/kitchen/0.png", dark_grey)
        single = self.answers(picture)[0]
        self.assertEqual(single, self.answers("runs")[0])
        self.assertEqual(single, self.answers(self.write_image(
            "eight.png", (dark_grey >> 2).astype(np.uint8)))[0])

    def test_runs_of_one_training_share_a_range(self):
        rooms = [room for room in ("kitchen", "corridor", "office") for _ in range(8)]
        self.write_infrared("dark.bag", rooms, .4)
        self.write_infrared("day.bag", rooms, 1.2)
        said = self.train("dark.bag", "day.bag")[1]
        self.assertEqual(said.count("0 .. 1023 of 16 bits"), 2, said)


class RedAndBlueTest(FieldCase):
    def test_compressed_images_are_those_that_image_transport_makes_of_them(self):
        """Compares raw images and losslessly compressed ones with each order of the channels."""
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


if __name__ == "__main__":
    unittest.main()
