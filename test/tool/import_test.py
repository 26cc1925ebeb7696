#!/usr/bin/env python3
"""Tests place_tool import on tiny folders in each layout of doc/datasets.md."""
import json
import unittest

import rosbag
from tool_case import ROOMS, ToolCase, paint


class ImportTest(ToolCase):
    def labels_of(self, bag_name):
        """Returns (stamp, label) of each image of a bag, read with ROS' Python library."""
        labels, label = [], None
        with rosbag.Bag(str(self.folder / bag_name)) as bag:
            for topic, message, _ in bag.read_messages():
                if topic == "/place_label":
                    label = message.data
                else:
                    labels.append((message.header.stamp.to_sec(), label))
        return labels

    def import_pictures(self, names, *arguments):
        for view, name in enumerate(names):
            self.write_image(f"data/{name}", paint("kitchen", view))
        self.succeed("import", "data", "--out", "run.bag", *arguments)
        return self.labels_of("run.bag")

    def test_rooms(self):
        labels = self.import_pictures(["kitchen/2.png", "hall/9.jpg", "hall/10.jpg", "loose.png"],
                                      "--rate", 2)
        start = labels[0][0]
        self.assertEqual([(stamp - start, label) for stamp, label in labels],
                         [(0, "hall"), (0.5, "hall"), (1, "kitchen")])

    def test_a_folder_of_runs_is_read_as_train_reads_it(self):
        self.write_run("parent/monday", views=1)
        self.assertEqual(self.figures("import", "parent", "--out", "run.bag")["places"], sorted(ROOMS))
        self.write_run("parent/tuesday", views=1)
        line = self.refuse("import", "parent", "--out", "two.bag")
        self.assertIn("The folder parent contains 2 recordings; give one of them, such as parent/monday, "
                      "or put the images of each room directly into its folder.", line)

    def test_one_of_a_kind_is_counted_as_one(self):
        self.write_run("rooms", views=1, rooms=["kitchen"])
        self.assertEqual(self.succeed("import", "rooms", "--out", "run.bag"),
                         "run.bag: 1 image of 1 place\n")

    def test_a_bag_that_is_replaced_is_told(self):
        self.write_run("rooms", views=1)
        for command, bag in ((("import", "rooms", "--out", "run.bag"), "run.bag"),
                             (("simulate", "--out", "runs", "--conditions", "night", "--size", "32x24"),
                              "runs/night.bag")):
            self.assertNotIn("replaced", self.run_tool(*command).stderr)
            self.assertIn(f"note: {bag} existed and was replaced.", self.run_tool(*command).stderr)

    def test_a_ros_2_bag_is_named(self):
        (self.folder / "ros2").mkdir()
        (self.folder / "ros2/metadata.yaml").write_text("rosbag2_bagfile_information:\n")
        (self.folder / "ros2/ros2_0.db3").write_bytes(b"SQLite format 3\0")
        self.assertIn("ros2 is a ROS 2 bag; convert it", self.refuse("import", "ros2", "--out", "run.bag"))

    def test_indecs_finds_light_room_marker_and_angle_wherever_they_stand(self):
        for names in (["cloudy/kitchen/kitchen_07_120.png", "cloudy/kitchen/kitchen_07_30.png",
                       "cloudy/printer_area/printer_area_01_000.png"],
                      ["kitchen/Cloudy/7_120.png", "kitchen/Cloudy/7_30.png",
                       "printer_area/Cloudy/1_0.png"],
                      ["kitchen_cloudy_07_120.png", "kitchen_cloudy_07_030.png",
                       "printer_area_cloudy_01_000.png"]):
            labels = self.import_pictures(names, "--layout", "indecs")
            self.assertEqual([label for _, label in labels], ["kitchen", "kitchen", "printer_area"])
            self.assertAlmostEqual(labels[2][0] - labels[0][0], 0.4)
            for path in (self.folder / "data").rglob("*.png"):
                path.unlink()

    def test_indecs_run_is_one_condition(self):
        names = ["night/kitchen/1_0.png", "sunny/kitchen/1_0.png", "sunny/hall/1_0.png"]
        labels = self.import_pictures(names, "--layout", "indecs", "--condition", "sunny")
        self.assertEqual([label for _, label in labels], ["hall", "kitchen"])
        indecs = ("import", "data", "--out", "b.bag", "--layout", "indecs")
        self.assertIn("--condition", self.refuse(*indecs))
        self.assertIn("no images of the condition cloudy, only of night, sunny; give",
                      self.refuse(*indecs, "--condition", "cloudy"))

    def test_idol_is_in_the_order_of_its_stamps(self):
        labels = self.import_pictures(
            ["png/t1125496219.5_rCR_x1.0_y-2.0_a0.5.png", "png/t1125496218.25_rKT_x6.5_y5.3_a.3.png"],
            "--layout", "idol")
        self.assertEqual(labels, [(1125496218.25, "KT"), (1125496219.5, "CR")])
        self.write_image("data/png/holiday.png", paint("office", 0))
        self.assertIn("holiday.png",
                      self.refuse("import", "data", "--out", "b.bag", "--layout", "idol"))

    def test_rooms_whose_names_look_alike_are_named(self):
        for room in ("Office", "office", "kitchen"):
            self.write_image(f"data/{room}/1.png", paint("kitchen", 0))
        result = self.run_tool("import", "data", "--out", "run.bag", "--json", "-")
        self.assertEqual(result.returncode, 0)
        self.assertIn("warning: 'Office' and 'office'", result.stderr)
        self.assertIn("'Office' and 'office'", json.loads(result.stdout)["warnings"][0])

    def test_two_recordings_in_one_folder_are_named(self):
        for time in (1125496218, 1125496219, 1125796219):
            self.write_image(f"data/t{time}_rKT_x6.5_y5.3_a.3.png", paint("kitchen", 0))
        result = self.run_tool("import", "data", "--out", "run.bag", "--layout", "idol")
        self.assertEqual(result.returncode, 0)
        self.assertIn("More than a day lies between data/t1125496219_rKT", result.stderr)
        self.assertIn("and data/t1125796219_rKT", result.stderr)

    def test_times_that_are_not_in_seconds_are_refused(self):
        idol = ("import", "data", "--out", "run.bag", "--layout", "idol")
        self.write_image("data/t1125496218.25_rKT_x6.5_y5.3_a.3.png", paint("kitchen", 0))
        for time in ("1125496218370", "4294967296", "-1"):
            picture = self.write_image(f"data/t{time}_rKT_x6.5_y5.3_a.3.png", paint("kitchen", 1))
            line = self.refuse(*idol)
            self.assertIn(picture.name, line)
            self.assertIn("seconds", line)
            picture.unlink()
        for time in ("inf", "nan", "1e999"):
            picture = self.write_image(f"data/t{time}_rKT_x6.5_y5.3_a.3.png", paint("kitchen", 1))
            self.assertIn("is not named like", self.refuse(*idol))
            picture.unlink()

    def test_a_rate_so_low_that_times_leave_the_range_of_ros_is_refused(self):
        self.write_run("rooms", views=1)
        line = self.refuse("import", "rooms", "--out", "run.bag", "--rate", "1e-12")
        self.assertIn("run.bag: its image 2 has the time 1001000000000 s", line)
        self.assertIn("rate", line)

    def test_further_words_of_idol_names_have_no_meaning(self):
        labels = self.import_pictures(["t1125496218.25_rKT_x6.5_y5.3_a0.5_top_retouched.png"],
                                      "--layout", "idol")
        self.assertEqual(labels, [(1125496218.25, "KT")])

    def test_a_rate_of_layouts_with_stamps_is_refused(self):
        self.write_image("data/t1125496218.25_rKT_x6.5_y5.3_a0.5.png", paint("kitchen", 0))
        for rate in (2, 5):
            self.assertIn("--rate requires --layout rooms or indecs",
                          self.refuse("import", "data", "--out", "b.bag", "--layout", "idol",
                                      "--rate", rate, status=2))

    def test_a_folder_that_cannot_name_a_room_is_named(self):
        self.write_run("data", views=1)
        self.write_image("data/unknown/1.png", paint("kitchen", 0))
        line = self.refuse("import", "data", "--out", "run.bag")
        self.assertIn("data/unknown/1.png: the label 'unknown'", line)
        self.assertNotIn("run.bag", line)

    def test_cold_takes_labels_from_its_list(self):
        names = ["t1152886490.25_x0.205133_y0.000557_a0.002507.jpeg",
                 "t1152886491.5_x0.3_y0.0_a0.0.jpeg"]
        places = self.folder / "data/localization/places.lst"
        places.parent.mkdir(parents=True)
        places.write_text(f"{names[0]} CR-A\n{names[1]} PA-A\n")
        labels = self.import_pictures([f"std_cam/{name}" for name in names], "--layout", "cold")
        self.assertEqual(labels, [(1152886490.25, "CR-A"), (1152886491.5, "PA-A")])
        labels = self.import_pictures([f"omni_cam/{name}" for name in names], "--layout", "cold", "--camera",
                                      "omni_cam")
        self.assertEqual(labels, [(1152886490.25, "CR-A"), (1152886491.5, "PA-A")])
        self.assertIn("--camera requires --layout cold",
                      self.refuse("import", "data", "--out", "b.bag", "--camera", "omni_cam", status=2))
        places.write_text(f"{names[0]}\n")
        self.assertIn("places.lst line 1",
                      self.refuse("import", "data", "--out", "b.bag", "--layout", "cold"))

    def test_a_bag_whose_labels_a_file_would_replace_is_refused(self):
        self.write_run("rooms", views=1)
        for name in ("run.labels.yaml", "run.labels.yml", "labels.dat"):
            file = self.folder / "lab" / name
            file.parent.mkdir(exist_ok=True)
            file.write_text("labels: [{from: 0, place: old}]")
            self.assertIn(f"lab/{name}", self.refuse("import", "rooms", "--out", "lab/run.bag"))
            file.unlink()
        self.succeed("import", "rooms", "--out", "lab/run.bag")
        self.assertEqual(self.figures("info", "lab/run.bag")["labels_file"], "")
        file.write_text("1000000000 old\n")
        self.assertEqual(self.figures("info", "lab/run.bag")["labels_file"], "lab/labels.dat")
        self.assertIn("labels in lab/labels.dat, s", self.succeed("info", "lab/run.bag"))
        said = self.succeed("info", "lab/run.bag", "--label", "hall")
        self.assertNotIn("labels.dat", said)

    def test_a_simulation_whose_labels_a_file_would_replace_is_refused(self):
        (self.folder / "runs").mkdir()
        file = self.folder / "runs/night.labels.yaml"
        file.write_text("labels: [{from: 0, place: old}]")
        simulate = ("simulate", "--out", "runs", "--conditions", "cloudy,night", "--size", "32x24")
        self.assertIn("runs/night.labels.yaml", self.refuse(*simulate))
        self.succeed("simulate", "--out", "runs", "--conditions", "night", "--size", "32x24",
                     "--format", "images")

    def test_images_that_cannot_be_used(self):
        self.write_image("data/kitchen/1.png", paint("kitchen", 0))
        (self.folder / "data/kitchen/2.png").write_bytes(b"no image")
        result = self.run_tool("import", "data", "--out", "run.bag")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("2.png", result.stderr)
        self.assertIn("places.lst",
                      self.refuse("import", "data", "--out", "cold.bag", "--layout", "cold"))


if __name__ == "__main__":
    unittest.main()
