#!/usr/bin/env python3
"""Tests run_ctest.py on a project of four tests: catkin_test_results counts what ctest reports."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

RUN_CTEST = pathlib.Path(os.environ["PLACE_RECOGNITION_SOURCE_DIR"]) / "test/run_ctest.py"
CMAKE, CTEST = sys.argv[1:3]

PROJECT = """\
cmake_minimum_required(VERSION 3.16)
project(four LANGUAGES NONE)
include(CTest)
add_test(NAME passes COMMAND ${CMAKE_COMMAND} -E echo fine)
add_test(NAME fails COMMAND ${CMAKE_COMMAND} -E cat "no <such> file")
add_test(NAME skips COMMAND sh -c "exit 77")
set_tests_properties(skips PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME unbuilt COMMAND ${CMAKE_CURRENT_BINARY_DIR}/unbuilt)
"""


class RunCtestTest(unittest.TestCase):
    def test_every_entry_is_a_case(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "CMakeLists.txt").write_text(PROJECT)
            subprocess.run([CMAKE, "-S", folder, "-B", folder / "build"], check=True,
                           stdout=subprocess.DEVNULL)
            result = folder / "results/ctest.xml"
            done = subprocess.run([sys.executable, RUN_CTEST, CTEST, folder / "build", result],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            suite = ET.parse(result).getroot()
        self.assertEqual({key: suite.get(key) for key in ("tests", "failures", "skipped")},
                         {"tests": "4", "failures": "2", "skipped": "1"})
        outcome = {case.get("name"): [child.tag for child in case] for case in suite}
        self.assertEqual(outcome, {"passes": [], "fails": ["failure"], "skips": ["skipped"],
                                   "unbuilt": ["failure"]})
        self.assertIn("no <such> file", suite.find("./testcase[@name='fails']/failure").text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
