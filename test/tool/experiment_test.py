#!/usr/bin/env python3
"""Tests place_tool experiment on painted rooms in the layouts of public data sets."""
import csv
import json
import pathlib
import unittest
from xml.etree import ElementTree

from tool_case import ROOMS, ToolCase, paint

CONDITIONS = ("cloudy", "night", "sunny")


class ExperimentCase(ToolCase):
    def write_indecs(self, views=5):
        for seed, condition in enumerate(CONDITIONS):
            self.write_run(f"data/{condition}", views=views, seed=seed)

    def experiment(self, name, *arguments, out="out", data="data"):
        return self.figures("experiment", name, "--data", data, "--out", out, *arguments)

    def table(self, path):
        with open(self.folder / path, newline="") as file:
            return list(csv.reader(file))

    def bytes_of(self, folder):
        return {path.relative_to(self.folder / folder): path.read_bytes()
                for path in (self.folder / folder).rglob("*") if path.is_file()}


class PlacesTest(ExperimentCase):
    def test_final_table_says_what_was_right(self):
        self.write_indecs()
        self.experiment("indecs-global")
        rows = self.table("out/table_8_6.csv")
        self.assertEqual(rows[0][:5], ["room", "tested on", *CONDITIONS])
        by_set = {(row[0], row[1]): row[2:5] for row in rows[1:]}
        for room in ROOMS:
            for i, condition in enumerate(CONDITIONS):
                self.assertEqual(by_set[room, condition][i], "", "never tested on what it learned")
        rates = [float(rate) for key, row in by_set.items() if key[0] in ROOMS
                 for rate in row[:1] if rate]
        self.assertEqual(len(rates), 2 * len(ROOMS))
        self.assertAlmostEqual(sum(rates) / len(rates), float(by_set["average", ""][0]), places=2)
        self.assertEqual(self.table("out/table_8_1.csv")[-1], ["all", "15", "15", "15"])

    def test_damaged_images_are_left_out_and_counted(self):
        self.write_indecs()
        for name in ("night/kitchen/000.png", "night/office/002.png"):
            (self.folder / "data" / name).write_bytes(b"no image")
        self.write_image("data/sunny/office/001.png", 0 * paint("office", 1))
        for name, more in (("indecs-global", ()), ("bins", ("--part", "1/99")), ("cues", ())):
            with self.subTest(name=name):
                result = self.run_tool("experiment", name, "--data", "data", "--out", name, "--json",
                                       "-", *more)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("2 images cannot be used and were skipped", result.stderr)
                self.assertIn("night/kitchen/000.png", result.stderr)
                self.assertEqual("1 image of a single colour" in result.stderr, name != "bins")
                figures = json.loads(result.stdout)
                self.assertEqual((figures["pictures"], figures["unusable_images"]), (43, 2))
        self.assertEqual(self.table("indecs-global/table_8_1.csv")[-1], ["all", "15", "13", "15"])

    def test_second_run_computes_nothing_and_a_lost_cell_only_itself(self):
        self.write_indecs()
        self.assertEqual(self.experiment("indecs-global")["computed"], 3)
        before = self.bytes_of("out")
        self.assertEqual(self.experiment("indecs-global")["computed"], 0)
        next((self.folder / "out/cells").iterdir()).unlink()
        self.assertEqual(self.experiment("indecs-global")["computed"], 1)
        self.assertEqual(self.bytes_of("out"), before)

    def test_a_changed_image_is_noticed(self):
        self.write_indecs()
        self.experiment("indecs-global")
        self.write_image("data/night/kitchen/000.png", paint("kitchen", 77))
        self.assertEqual(self.experiment("indecs-global")["computed"], 3)

    def test_same_bytes_from_one_and_two_threads_and_from_parts(self):
        self.write_indecs(views=3)
        arguments = ("--max-dimensions", 1)  # four single descriptors at five scales
        whole = self.experiment("descriptors", *arguments, "--threads", 1, out="one")
        self.assertEqual(whole["cells"], 20)
        for part, missing in ((2, 10), (1, 0)):
            figures = self.experiment("descriptors", *arguments, "--threads", 2, "--part",
                                      f"{part}/2", out="two")
            self.assertEqual((figures["computed"], figures["missing"]), (10, missing))
        self.assertEqual(self.bytes_of("one"), self.bytes_of("two"))

    def test_reduction_keeps_no_more_vectors_for_a_lower_rate(self):
        self.write_indecs(views=3)
        self.experiment("reduction")
        vectors = [float(row[3].split()[0]) for row in self.table("out/table_8_7.csv")[1:]]
        self.assertEqual(vectors, sorted(vectors, reverse=True))
        self.assertTrue((self.folder / "out/reduction_global.svg").is_file())

    def test_salient_viewpoints_are_shown(self):
        self.write_indecs(views=13)  # two viewpoints per room
        self.experiment("learning-curve")
        rows = self.table("out/viewpoints.csv")[1:]
        self.assertEqual(len(rows), 3 * 5)
        page = (self.folder / "out/viewpoints.html").read_text()
        self.assertEqual(page.count("data:image/jpeg;base64,"), len(rows))
        for row in rows:
            self.assertIn(f"{row[1]}, viewpoint {row[2]}: {row[3]} % without it", page)

    def test_cues_are_combined_in_two_ways(self):
        self.write_indecs(views=8)
        self.experiment("cues")
        rows = self.table("out/cues.csv")[1:]
        self.assertEqual([row[:2] for row in rows],
                         [[cues, name] for cues in ("thesis", "default")
                          for name in (*CONDITIONS, "mean")])
        for row in rows:
            for rate in row[3:]:
                self.assertGreater(float(rate), 60, row)  # chance: 33 %

    def test_every_nth_image(self):
        self.write_indecs()
        self.assertEqual(self.experiment("indecs-global", "--every", 2)["pictures"], 27)


class LayoutsTest(ExperimentCase):
    def test_sequences_of_idol(self):
        codes = {"kitchen": "KT", "corridor": "CR", "office": "EO"}
        for seed, condition in enumerate(("cloudy1", "night2", "night1")):
            for i, room in enumerate(sorted(ROOMS) * 3):
                self.write_image(f"data/dum_{condition}/t11254962{seed}{i}.5_r{codes[room]}_x1.0"
                                   f"_y-2.0_a0.5.png", paint(room, i, seed))
        figures = self.experiment("indecs-global", "--layout", "idol")
        self.assertEqual((figures["cells"], figures["pictures"]), (2, 27))
        self.assertEqual(self.table("out/table_8_1.csv")[1:3],
                         [["CR", "3", "6"], ["EO", "3", "6"]])

    def test_sequences_of_cold_labelled_by_image_and_by_time(self):
        rooms = sorted(ROOMS)
        for seed, sequence in enumerate(("seq1_cloudy1", "seq1_sunny1")):
            names = []
            for i in range(9):
                names.append(f"t115288649{i}.25_x0.2_y0.0_a0.1.jpeg")
                self.write_image(f"data/{sequence}/std_cam/{names[-1]}",
                                   paint(rooms[i // 3], i, seed))
            labels = self.folder / "data" / sequence
            if seed == 0:
                (labels / "localization").mkdir()
                (labels / "localization/places.lst").write_text(
                    "".join(f"{name} {rooms[i // 3]}-A\n" for i, name in enumerate(names)))
            else:  # as in COLD-Meta: from a time on
                (labels / "labels.dat").write_text(
                    "".join(f"115288649{3 * i}.0 {room}-A\n" for i, room in enumerate(rooms)))
        self.experiment("indecs-global", "--layout", "cold")
        self.assertEqual(self.table("out/table_8_1.csv")[1:],
                         [[f"{room}-A", "3", "3"] for room in rooms] + [["all", "9", "9"]])

    def test_folder_of_one_condition(self):
        self.write_run("data/night")
        self.assertIn("two conditions", self.refuse("experiment", "bins", "--data", "data", "--out",
                                                    "out"))
        self.refuse("experiment", "bins", "--data", "data", "--out", "out", "--part", "3/2",
                    status=2)


class MaterialsTest(ExperimentCase):
    def test_samples_are_folders_or_blocks(self):
        rooms = sorted(ROOMS)[:2]
        for room in rooms:
            for sample in range(3):
                for view in range(2):
                    self.write_image(f"samples/{room}/{'abc'[sample]}/{view}.png",
                                       paint(room, view, sample))
        figures = self.experiment("materials", data="samples")
        features, kernels, splits = 3, 24, 6
        self.assertEqual(figures["cells"], features * kernels * splits)
        for number in range(1, 7):
            self.assertGreater(len(self.table(f"out/table_7_{number}.csv")), 4)
        self.write_run("blocks", views=4, rooms=rooms)
        figures = self.experiment("materials", "--part", "1/24", data="blocks", out="parts")
        self.assertEqual((figures["cells"], figures["computed"]), (features * kernels * 12, 36))
        results = json.loads((self.folder / "out/results.json").read_text())
        self.assertEqual(len(results), features * kernels * splits)
        for result in results:
            self.assertEqual(len(result["result"]), 8, "four C and two ways of many classes")


class FiguresTest(ExperimentCase):
    def test_figures_of_the_documents_are_what_the_command_draws(self):
        figures = self.figures("experiment", "figures", "--out", "out")
        self.assertEqual((figures["cells"], figures["pictures"]), (19, 0))
        images = pathlib.Path(__file__).resolve().parents[2] / "doc/images"
        for name in ("figure_5_5", "kernels", "figure_6_1", "figure_6_2"):
            drawn = (self.folder / f"out/{name}.svg").read_bytes()
            self.assertEqual(drawn, (images / f"{name}.svg").read_bytes(), name)
            ElementTree.fromstring(drawn)

    def test_figures_take_no_data_and_the_others_need_it(self):
        self.assertIn("--data", self.refuse("experiment", "figures", "--data", "data", "--out",
                                            "out", status=2))
        self.assertIn("--data", self.refuse("experiment", "bins", "--out", "out", status=2))


if __name__ == "__main__":
    unittest.main()
