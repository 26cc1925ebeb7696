#!/usr/bin/env python3
"""Tests --config and --set, the presets in config/, and their documentation."""
import re
import unittest

from tool_case import SOURCE, ToolCase, paint


class ConfigurationTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_image("a.png", paint("kitchen", 0))

    def features(self, *arguments):
        return self.succeed("features", "a.png", *arguments)

    def test_every_shipped_preset_loads_by_name_and_by_path(self):
        self.install_network()
        presets = sorted((SOURCE / "config").glob("*.yaml"))
        self.assertGreaterEqual(len(presets), 2)
        for preset in presets:
            self.assertEqual(self.features("--config", preset.stem),
                             self.features("--config", preset))

    def test_the_default_of_features_is_the_preset_crfh(self):
        self.assertEqual(self.features(), self.features("--config", "crfh"))

    def test_the_default_of_train_is_the_preset_default(self):
        self.write_run("run")
        self.succeed("train", "run", "--model", "./a.places")
        self.succeed("train", "run", "--model", "./b.places", "--config", "default")
        self.assertEqual((self.folder / "a.places").read_bytes(),
                         (self.folder / "b.places").read_bytes())

    def test_set_overwrites_the_file_key_by_key(self):
        (self.folder / "mine.yaml").write_text(
            "cues: [{name: mine, feature: {type: crfh, descriptors: [Lx], bins: [4]}}]\n")
        by_file = self.features("--config", "mine.yaml")
        self.assertLessEqual(len(by_file.split()), 16)
        by_set = self.features("--set", "cues.crfh.feature.descriptors=Lx", "--set",
                               "cues.crfh.feature.bins=[4]")
        self.assertEqual(by_file, by_set)
        self.assertNotEqual(by_file, self.features("--config", "mine.yaml", "--set",
                                                   "cues.mine.feature.scales=9"))

    def test_the_examples_of_the_help_work_with_the_default(self):
        for verb, *arguments in (("features", "a.png"), ("train", "nowhere", "--model", "m"),
                                 ("tune", "nowhere", "--out", "t.yaml")):
            text = " ".join(self.succeed(verb, "--help").split())
            examples = re.search(r"KEY=VALUE .*? for example (\S+) or (\S+);", text).groups()
            options = [word for example in examples for word in ("--set", example)]
            if verb == "features":
                self.features(*options)
            else:
                self.assertIn("nowhere does not exist", self.refuse(verb, *arguments, *options))

    def test_mistakes_are_named_with_where_they_stand(self):
        (self.folder / "mine.yaml").write_text("svm: {cost: 5}\n")
        line = self.refuse("train", "nowhere", "--model", "m", "--config", "mine.yaml")
        for words in ("mine.yaml", "'cost'", "'svm'", "c, multiclass"):
            self.assertIn(words, line)
        for arguments, words in (
                (("--config", "absent.yaml"), "absent.yaml"),
                (("--config", "crhf"), "crfh, crfh_colour"),
                (("--set", "svm.cost=5"), "'cost'"),
                (("--set", "svm.cc=10"), "(did you mean c?); the known ones are: c, multiclass"),
                (("--set", "svm.c"), "key=value"),
                (("--set", "svn.c=10"), "there is no 'svn' (did you mean svm?)"),
                (("--set", "svm.c.d=10"), "there is no 'd' in 'svm.c'; set svm.c as a whole"),
                (("--set", "cues.crfh.kernel.gamma=30"), "there is no 'crfh' in 'cues'; the known "
                 "ones are: colours, tints, edges, shapes, directions."),
                (("--set", "cues={}"), "Option 'cues' is empty; give its keys"),
                (("--set", "cues=[{}]"), "Option 'cues[0]' is empty; give its keys"),
                (("--set", "cues.colours={}"), "Option 'cues[0]' is empty; give its keys"),
                (("--config", "crfh", "--set", "cues.crhf.kernel.gamma=1"),
                 "there is no 'crhf' in 'cues' (did you mean crfh?)"),
                (("--config", "crfh", "--set", "cues.crfh.kernal.gamma=1"),
                 "there is no 'kernal' in 'cues.crfh' (did you mean kernel?)"),
                (("--set", "svm.c=much"), "'svm.c'"),
                (("--set", "svm.c=-1"), "svm.c"),
                (("--set", "cues.sift.kernel.gamma=1"), "'sift'"),
                (("--config", "sift", "--set", "cues.sift.kernel.type=linear"),
                 "use one of: local-match"),
                (("--config", "lbp", "--set", "cues.lbp.kernel.type=local-match"),
                 "linear, polynomial, gaussian, sigmoid, chi-squared, intersection"),
                (("--config", "embedding", "--set", "cues.embedding.kernel.type=chi-squared"),
                 "not defined for negative elements; use one of: linear, polynomial, gaussian")):
            self.assertIn(words, self.refuse("train", "nowhere", "--model", "m", *arguments))

    def test_document_is_up_to_date(self):
        self.assertEqual((SOURCE / "doc/configuration.md").read_text(), self.succeed("document"),
                         "run: place_tool document > doc/configuration.md")


if __name__ == "__main__":
    unittest.main()
