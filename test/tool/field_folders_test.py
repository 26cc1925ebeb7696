#!/usr/bin/env python3
"""Folders of images like those described in public reports."""
import os
import unicodedata
import unittest

import cv2

from field_case import MODEL, FieldCase
from tool_case import ROOMS, paint


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
            if not cv2.haveImageWriter("." + ending):
                ending = "png"  # OpenCV 4.2 has no JPEG 2000
            self.write_image(f"run/kitchen/{view}.{ending}", paint("kitchen", view))
            self.write_image(f"run/corridor/2024-05-{view + 10}/{view}.png",
                             paint("corridor", view))
        figures, said = self.train("run")
        self.assertEqual({room: of["count"] for room, of in figures["rooms"].items()},
                         {"corridor": 8, "kitchen": 8, "office": 8})
        self.assertNotIn("warning: Nothing", said)
        self.assertEqual(self.figures("import", "run", "--out", "run.bag")["images"], 24)

    def test_images_without_an_extension_are_read(self):
        self.write_run("run", rooms=["office", "corridor"])
        (self.folder / "run/kitchen").mkdir()
        for view in range(8):
            data = cv2.imencode((".jpg", ".png", ".webp")[view % 3], paint("kitchen", view))[1].tobytes()
            (self.folder / f"run/kitchen/{('', 'frame', 'frame.')[view % 3]}{view:04d}").write_bytes(data)
        (self.folder / "run/kitchen/README").write_text("BM and other notes")
        figures, said = self.train("run")
        self.assertEqual(figures["rooms"]["kitchen"]["count"], 8, said)
        self.assertIn("kitchen", self.succeed("recognize", "run/kitchen/0000", *MODEL[:2]))
        self.assert_names(self.refuse("recognize", "run/kitchen/README", *MODEL[:2]), "README")

    def test_named_pipes_do_not_block(self):
        self.write_run("run")
        self.write_labelled("run.bag", 1000, ["kitchen"] * 4 + ["office"] * 4, [(0, "kitchen")])
        self.train("run")
        for name in ("run/kitchen/pipe.png", "run/pipe.bag", "pipe", "pipe.png", "pipe.bag"):
            os.mkfifo(self.folder / name)
        self.assertEqual(self.train("run")[0]["images"], 24)
        for verb in (("info", "pipe"), ("info", "pipe.bag"), ("features", "pipe"), ("train", "pipe", *MODEL),
                     ("recognize", "pipe.png", *MODEL[:2]), ("recognize", "pipe", *MODEL[:2]),
                     ("recognize", "run", "--model", "./pipe"),
                     ("train", "run.bag", "--labels", "pipe", *MODEL),
                     ("train", "run", *MODEL[:2], "--config", "pipe")):
            with self.subTest(verb):
                self.assert_names(self.refuse(*verb), "pipe")
        os.mkfifo(self.folder / "run.labels.yaml")
        self.assert_names(self.refuse("info", "run.bag"), "run.labels.yaml", "not a file")

    def test_an_image_beside_runs_does_not_make_them_rooms(self):
        for run in ("monday", "tuesday"):
            self.write_run(f"runs/{run}")
        self.write_image("runs/map.png", paint("office", 1))
        self.assertEqual(self.rooms_of("runs"), sorted(ROOMS))
        self.assertEqual(self.rooms_of("runs/monday"), sorted(ROOMS))
        self.write_image("runs/monday/map.png", paint("office", 1))
        figures, said = self.train("runs/monday")
        self.assertEqual(sorted(figures["rooms"]), sorted(ROOMS))
        self.assertIn("1 image without a label", said)

    def test_folders_that_give_nothing_are_named(self):
        self.write_run("run")
        (self.folder / "run/attic").mkdir()
        (self.folder / "run/attic/IMG_1.HEIC").write_bytes(b"\0\0\0\x18ftypheic")
        (self.folder / "run/cellar").mkdir()
        (self.folder / "run/loft").mkdir()
        (self.folder / "run/loft/1.jpg").write_bytes(b"")
        for said in (self.train("run")[1],
                     self.run_tool("import", "run", "--out", "run.bag").stderr):
            self.assert_names(said, "run/attic: it contains 1 .heic file",
                              "run/cellar: it is empty", "run/loft/1.jpg: it is empty")
        self.assert_names(self.train("run")[1],
                          "'loft' is not learned: its 1 image cannot be used (run/loft/1.jpg: it")
        self.assert_names(self.run_tool("import", "run", "--out", "run2.bag").stderr,
                          "'loft' is not in the bag: its images cannot be used (run/loft/1.jpg")

    def test_copies_of_images_are_counted(self):
        self.write_run("run")
        kitchen = self.folder / "run/kitchen"
        whole = next(kitchen.iterdir()).read_bytes()
        for name in ("1.jpg.tmp", "2.jpg.tmp", "3.JPG.part", "4.png.crdownload", "5.jpg~", "6.jpg.bak",
                     "7.jpg.swp", "notes.txt~", "8.jpg.json"):
            (kitchen / name).write_bytes(whole)
        for said in (self.train("run")[1],
                     self.run_tool("import", "run", "--out", "run.bag").stderr):
            self.assertEqual(said.count("run/kitchen: skipped 1 .bak file, 1 .crdownload file, "
                                        "1 .jpg~ file, 1 .part file, 1 .swp file and 2 .tmp files, whose "
                                        "names indicate unfinished or older copies of images; rename those "
                                        "that should be used."), 1, said)

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
        self.assert_names(" ".join(figures["warnings"]), "run/old", "a broken link")

    @unittest.skipUnless(os.geteuid() == 0, "to become somebody without rights")
    def test_a_folder_that_may_not_be_read(self):
        self.write_run("runs/run")
        for folder in ("runs/run/attic", "runs/backup", "runs/lost+found"):
            (self.folder / folder).mkdir()
            (self.folder / folder).chmod(0)
        result = self.run_as_nobody("train", "runs", *MODEL)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_names(result.stderr, "runs/run/attic", "runs/backup", "Permission denied")
        self.assertNotIn("lost+found", result.stderr)

    def test_two_names_of_one_room(self):
        names = [unicodedata.normalize(form, "Küche") for form in ("NFC", "NFD")]
        for i, name in enumerate([*names, names[0] + " ", "Kü\u200bche", "\u00adK\u200eüche"]):
            for view in range(4):
                self.write_image(f"run/{name}/{view}.png", paint("kitchen", 4 * i + view))
        for i, name in enumerate(("Office_A", "office_a")):
            for view in range(4):
                self.write_image(f"run/{name}/{view}.png", paint("office", 4 * i + view))
        figures, said = self.train("run")
        self.assertEqual(sorted(figures["rooms"]), sorted([names[0], "Office_A", "office_a"]))
        self.assertEqual(figures["rooms"][names[0]]["count"], 20)
        self.assert_names(said, "'Office_A' and 'office_a' differ only in upper and lower case")


if __name__ == "__main__":
    unittest.main()
