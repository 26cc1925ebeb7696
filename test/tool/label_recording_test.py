#!/usr/bin/env python3
"""Tests the recordings and images that the server of place_tool label sends to its page."""
import socket
import unittest

import cv2
import numpy as np
import rosbag
import rospy
from label_case import START, TOPIC, LabelCase, jpeg, raw, span
from sensor_msgs.msg import CompressedImage
from std_msgs.msg import String


class RecordingTest(LabelCase):
    def test_split_bags_are_one_recording(self):
        self.record("run_0.bag", frames=20)
        self.record("run_1.bag", frames=20, start=START + 2)
        page = self.page("run_1.bag", "run_0.bag")  # ordered by time, not by name
        recording = page.get("recording")
        self.assertEqual([bag["name"] for bag in recording["bags"]], ["run_0.bag", "run_1.bag"])
        times = page.get("times?topic=" + TOPIC)
        self.assertEqual(len(times), 40)
        self.assertEqual(times, sorted(times))
        page.post("save", {"spans": [span(0, times[10] - .05, "a"),
                                     span(times[10] - .05, times[30] - .05, "b")]})
        self.assertEqual(self.stretches("run_0.bag"), [("a", 0, .95), ("b", .95, 1.9)])
        self.assertEqual(self.stretches("run_1.bag"), [("b", 0, .95)])
        spans = self.page("run_0.bag", "run_1.bag").get("recording")["spans"]
        self.assertEqual([label["place"] for label in spans], ["a", "b"])

    def test_a_label_is_carried_into_the_next_part(self):
        self.record("run_0.bag", frames=20, labels=[(0, "hall"), (10, "lab")])
        self.record("run_1.bag", frames=20, start=START + 2, labels=[(10, "attic")])
        page = self.page("run_1.bag", "run_0.bag")
        spans = page.get("recording")["spans"]
        self.assertEqual([label["place"] for label in spans], ["hall", "lab", "attic"])
        page.post("save", {"spans": spans})
        self.assertEqual(self.stretches("run_1.bag"), [("lab", 0, .95), ("attic", .95, 1.9)])

    def test_labels_behind_the_last_frame_are_none(self):
        self.record("a.bag", frames=20, labels=[(0, "hall")])
        with rosbag.Bag(str(self.folder / "a.bag"), "a") as bag:
            for seconds, place in ((10, "lab"), (20, "attic")):
                bag.write("/place_label", String(place), rospy.Time.from_sec(START + seconds))
        self.record("b.bag", frames=20, start=START + 60, labels=[(0, "lab")])
        page = self.page("a.bag", "b.bag")
        spans = page.get("recording")["spans"]
        self.assertEqual([label["place"] for label in spans], ["hall", "lab"])
        self.assertEqual(page.post("save", {"spans": spans})[0], 200)

    def test_images_of_before_the_clock_was_set(self):
        self.record("run.bag", frames=20, labels=[(0, "hall")])
        with rosbag.Bag(str(self.folder / "run.bag"), "a") as bag:
            for i in range(5):
                bag.write(TOPIC, jpeg(i), rospy.Time(10 + i))
        page = self.page("run.bag")
        self.assertAlmostEqual(page.get("recording")["duration"], 1.91, places=5)
        self.assertEqual(page.get("recording")["hidden"], 5)
        self.assertEqual(page.post("save", {"spans": [span(0, 1, "lab")]})[0], 200)
        self.assertEqual(self.stretches("run.bag"), [("lab", 0, .95)])
        result = self.run_tool("info", "run.bag")
        self.assertIn("run.bag: 5 images are more than a day away", result.stderr)

    def test_images_of_another_day_get_no_label(self):
        self.record("run.bag", frames=20)
        with rosbag.Bag(str(self.folder / "run.bag"), "a") as bag:
            for i in range(5):
                bag.write(TOPIC, jpeg(i), rospy.Time.from_sec(START + 200000 + i))
        page = self.page("run.bag")
        self.assertEqual(page.get("recording")["hidden"], 5)
        self.assertEqual(page.post("save", {"spans": [span(1, 1.91, "lab")]})[0], 200)
        self.assertIn("{from: 0.95, to: 1.91, place", self.text("run.labels.yaml"))
        spans = self.page("run.bag").get("recording")["spans"]
        self.assertEqual([(label["place"], round(label["to"], 6)) for label in spans], [("lab", 1.91)])

    def test_labels_count_for_all_topics(self):
        self.record("run.bag", topics=("/front/compressed", "/rear/compressed"))
        page = self.page("run.bag", "--image-topic", "/rear")
        recording = page.get("recording")
        self.assertEqual(recording["topic"], "/rear/compressed")
        self.assertEqual([topic["frames"] for topic in recording["topics"]], [40, 40])
        for topic in ("/front/compressed", "/rear/compressed"):
            self.assertEqual(page.picture(topic, 3).shape, (48, 64, 3))

    def test_images_are_those_of_the_frames(self):
        self.record("run.bag", frames=100)
        page = self.page("run.bag")
        for number in (0, 1, 57, 99, 57):
            self.assertAlmostEqual(page.picture(TOPIC, number).mean(), number + 28, delta=2)

    def test_compressed_chunks(self):
        for compression in ("bz2", "lz4"):
            with rosbag.Bag(str(self.folder / "run.bag"), "w", compression=compression) as bag:
                for i in range(20):
                    bag.write(TOPIC, jpeg(i), rospy.Time.from_sec(START + i))
            page = self.page("run.bag")
            self.assertAlmostEqual(page.picture(TOPIC, 17).mean(), 45, delta=2)

    def test_large_images_are_scaled_down(self):
        with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            bag.write(TOPIC, jpeg(0, (1536, 2048)), rospy.Time.from_sec(START))
        page = self.page("run.bag")
        self.assertEqual(page.picture(TOPIC, 0).shape, (96, 128, 3))
        self.assertEqual(page.picture(TOPIC, 0, "view").shape, (600, 800, 3))

    def test_encodings(self):
        colour = np.zeros((32, 48, 3), np.uint8)
        colour[:] = (200, 100, 50)  # BGR
        grey = np.full((32, 48), 90, np.uint8)

        def full_range(image, highest=65535):
            image[:4] = highest
            return image

        bayer = np.zeros((32, 48), np.uint8)
        bayer[0::2, 0::2], bayer[1::2, 1::2] = 50, 200  # rggb
        bayer[0::2, 1::2] = bayer[1::2, 0::2] = 100
        uyvy = np.full((32, 48, 2), 128, np.uint8)
        yuyv = np.zeros((32, 48, 2), np.uint8)
        yuyv[..., 0], yuyv[:, 0::2, 1], yuyv[:, 1::2, 1] = 100, 178, 93  # Y, U, V
        messages = {"/bgr8": (raw(colour, "bgr8"), (200, 100, 50)),
                    "/padded": (raw(colour, "bgr8", 7), (200, 100, 50)),
                    "/rgb8": (raw(colour[..., ::-1].copy(), "rgb8"), (200, 100, 50)),
                    "/bgra8": (raw(np.dstack([colour, grey]), "bgra8"), (200, 100, 50)),
                    "/mono8": (raw(grey, "mono8", 3), (90, 90, 90)),
                    "/mono16": (raw(full_range(grey.astype("<u2") * 257), "mono16", 2), (90, 90, 90)),
                    "/infrared": (raw(full_range(grey.astype("<u2") * 4, 1023), "16UC1"),
                                  (90, 90, 90)),
                    "/big_endian": (raw(full_range(grey.astype(">u2") * 257), "mono16"),
                                    (90, 90, 90)),
                    "/bayer": (raw(bayer, "bayer_rggb8"), (200, 100, 50)),
                    "/deep_bayer": (raw(bayer.astype("<u2") * 16, "bayer_rggb16"), (200, 100, 50)),
                    "/yuv": (raw(uyvy, "yuv422"), (128, 128, 128)),
                    "/yuy2": (raw(yuyv, "yuv422_yuy2", 4), (199, 107, 42)),
                    "/8UC1": (raw(grey, "8UC1"), (90, 90, 90)),
                    "/8UC3": (raw(colour, "8UC3", 5), (200, 100, 50))}
        messages["/big_endian"][0].is_bigendian = True
        with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            for topic, (message, _) in messages.items():
                bag.write(topic, message, rospy.Time.from_sec(START))
        page = self.page("run.bag")
        for topic, (_, pixel) in messages.items():
            picture = page.picture(topic, 0)
            self.assertEqual(picture.shape, (32, 48, 3), topic)
            np.testing.assert_allclose(picture[16, 24], pixel, atol=4, err_msg=topic)

    def test_frames_that_cannot_be_decoded_are_named(self):
        good = np.zeros((32, 48, 3), np.uint8)
        short = raw(good, "bgr8")
        short.data = short.data[:100]
        huge = raw(good, "mono8")
        huge.width = huge.height = huge.step = 65536
        bad = {"/empty": CompressedImage(), "/gif": CompressedImage(data=b"GIF89a"),
               "/cut": CompressedImage(data=jpeg(0).data[:40]), "/short": short, "/huge": huge,
               "/strange": raw(good, "hologram"), "/odd": raw(good[:, :47, :2].copy(), "yuv422_yuy2")}
        with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            for topic, message in bad.items():
                bag.write(topic, message, rospy.Time.from_sec(START))
        page = self.page("run.bag", "--image-topic", "/gif")
        for topic in bad:
            self.assertIn("cannot be decoded", page.picture(topic, 0)["problem"], topic)

    def test_formats_of_compressed_images(self):
        image = np.zeros((32, 48, 3), np.uint8)
        image[:] = (200, 100, 50)
        mosaic = np.zeros((32, 48), np.uint8)
        mosaic[0::2, 0::2], mosaic[1::2, 1::2] = 50, 200  # rggb
        mosaic[0::2, 1::2] = mosaic[1::2, 0::2] = 100
        large = np.tile(mosaic, (30, 1))  # 960 rows, which a JPEG could be reduced from
        as_is, exchanged, grey = (200, 100, 50), (50, 100, 200), (90, 90, 90)
        formats = [("rgb8; png compressed bgr8", ".png", image, as_is),
                   ("rgb8; png compressed rgb8", ".png", image, exchanged),
                   ("rgb8; png compressed", ".png", image, exchanged),
                   ("RGB8; jpeg compressed ", ".jpg", image, exchanged),
                   ("bgr16; png compressed", ".png", image.astype(np.uint16) * 16, exchanged),
                   ("compressed rgb8", ".jpg", image, as_is),
                   ("jpeg", ".jpg", image, as_is), ("", ".webp", image, as_is),
                   ("bgr8; webp compressed bgr8", ".webp", image, as_is),
                   ("mono8; jpeg compressed ", ".jpg", np.full((32, 48), 90, np.uint8), grey),
                   ("bayer_rggb8; png compressed", ".png", mosaic, as_is),
                   ("bayer_rggb8; jpeg compressed ", ".jpg", large, as_is),
                   ("bayer_rggb16; png", ".png", mosaic.astype(np.uint16) * 256, as_is),
                   ("bayer_rggb8; jpeg compressed bgr8", ".png", image, as_is)]
        with rosbag.Bag(str(self.folder / "run.bag"), "w") as bag:
            for i, (name, kind, pixels, _) in enumerate(formats):
                data = cv2.imencode(kind, pixels)[1].tobytes()
                bag.write("/camera", CompressedImage(format=name, data=data),
                          rospy.Time.from_sec(START + i))
        page = self.page("run.bag")
        for i, (name, _, _, pixel) in enumerate(formats):
            picture = page.picture("/camera", i)
            self.assertIsInstance(picture, np.ndarray, (name, picture))
            middle = picture[picture.shape[0] // 2, picture.shape[1] // 2]
            np.testing.assert_allclose(middle, pixel, atol=6, err_msg=name)

    def test_two_bags_with_one_labels_file_are_refused(self):
        for names in (("plain.1", "plain.2"), ("tue.bag", "tue.BAG")):
            for name in names:
                self.record(name)
            said = self.refuse("label", "--no-browser", names[0], "./" + names[1])
            for name in (*names, names[0].split(".")[0] + ".labels.yaml", "rename"):
                self.assertIn(name, said)
        (self.folder / "other").mkdir()
        self.record("other/tue.bag")
        page = self.page("tue.bag", "other/tue.bag")
        self.assertEqual(len(set(page.get("recording")["files"])), 2)

    def test_labels_from_a_file_or_an_option_are_shown(self):
        self.record("run.bag", labels=[(0, "said")])
        (self.folder / "other.yaml").write_text("labels: [{from: 0, place: written}]")
        for option, place in (("--labels=other.yaml", "written"), ("--label=given", "given")):
            page = self.page("run.bag", option)
            self.assertEqual([label["place"] for label in page.get("recording")["spans"]], [place])

    def test_input_that_is_not_a_recording_gives_one_line(self):
        self.write_run("rooms", views=1)
        (self.folder / "broken.bag").write_bytes(b"#ROSBAG V2.0\n" + bytes(100))
        with rosbag.Bag(str(self.folder / "empty.bag"), "w"):
            pass
        self.record("run.bag")
        for arguments in (("rooms",), ("no.bag",), ("broken.bag",), ("empty.bag",),
                          ("run.bag", "--image-topic", "/no"), ("run.bag", "--model", "nothing")):
            with self.subTest(arguments=arguments):
                self.refuse("label", "--no-browser", *arguments)

    def test_a_port_in_use_gives_one_line(self):
        self.record("run.bag")
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            self.assertIn(str(port), self.refuse("label", "run.bag", "--port", port))


if __name__ == "__main__":
    unittest.main()
