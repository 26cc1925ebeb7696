#!/usr/bin/env python3
"""Runs all tests of ctest, the only list of tests, for `catkin_make run_tests`.

run_ctest.py CTEST BUILD_FOLDER RESULT.xml: writes the results as JUnit XML, one case per test,
where `catkin_test_results` looks for them. Like catkin's own targets, it exits with 0 if tests
fail, so that a workspace continues with its next package.
"""
import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ET


def run(ctest, build):
    """Runs the tests; returns the elements of its Test.xml."""
    subprocess.run([ctest, "-T", "Test", "--no-compress-output", "--output-on-failure", "-j",
                    str(os.cpu_count())], cwd=build, check=False)
    tag = (build / "Testing/TAG").read_text().splitlines()[0]
    return ET.parse(build / "Testing" / tag / "Test.xml").findall("./Testing/Test")


def measurement(test, name):
    found = test.find(f"./Results/NamedMeasurement[@name='{name}']/Value")
    return "" if found is None else found.text or ""


def case(test):
    """Returns the JUnit element of one test."""
    element = ET.Element("testcase", classname="ctest", name=test.findtext("Name"),
                         time=measurement(test, "Execution Time") or "0")
    if test.get("Status") == "passed":
        return element
    reason = measurement(test, "Completion Status") or measurement(test, "Exit Code")
    if reason.startswith("SKIP_") or reason == "Disabled":
        ET.SubElement(element, "skipped", message=reason)
        return element
    failure = ET.SubElement(element, "failure", message=reason or "failed")
    failure.text = test.findtext("./Results/Measurement/Value")
    return element


def suite(tests):
    cases = [case(test) for test in tests]
    element = ET.Element("testsuite", name="ctest", tests=str(len(cases)), errors="0")
    for attribute, tag in (("failures", "failure"), ("skipped", "skipped")):
        element.set(attribute, str(sum(c.find(tag) is not None for c in cases)))
    element.extend(cases)
    return element


if __name__ == "__main__":
    result = pathlib.Path(sys.argv[3])
    result.parent.mkdir(parents=True, exist_ok=True)
    ET.ElementTree(suite(run(sys.argv[1], pathlib.Path(sys.argv[2])))).write(
        result, encoding="utf-8", xml_declaration=True)
