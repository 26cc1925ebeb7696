#!/usr/bin/env python3
"""Trains every preset of config/ on one run and tests it on another, both ways.

  . build/devel/setup.bash
  ./scripts/compare_presets.py RUN1 RUN2 [--presets crfh,sift] [--place-tool PATH]

Prints a table in Markdown: the mean of the rooms' rates both ways, features extracted and compared
in a second, size of the models. RUN1 and RUN2 are bags or folders of room/picture files. Nothing is
chosen on the run that is tested on.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

CONFIG = pathlib.Path(__file__).resolve().parent.parent / "config"


def run(place_tool, *words):
    """The figures that a verb writes with --json."""
    result = subprocess.run([*place_tool, *words, "--json", "-", "--progress", "none"],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            universal_newlines=True)
    if result.returncode:
        sys.exit(result.stderr)
    return json.loads(result.stdout[result.stdout.rindex("\n{") if "\n{" in result.stdout else 0:])


def measure(place_tool, preset, train, test, folder):
    model = str(folder / "compared.places")
    run(place_tool, "train", train, "--model", model, "--config", str(CONFIG / f"{preset}.yaml"))
    return run(place_tool, "evaluate", test, "--model", model)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs=2, metavar="RUN")
    parser.add_argument("--presets", help="names separated by commas; else all of config/")
    parser.add_argument("--place-tool", help="path of the program; else through rosrun")
    options = parser.parse_args()
    place_tool = ([options.place_tool] if options.place_tool
                  else ["rosrun", "place_recognition", "place_tool"])
    presets = (options.presets.split(",") if options.presets
               else sorted(path.stem for path in CONFIG.glob("*.yaml")))

    first, second = options.runs
    print("| preset | there | back | frames a second | support vectors | model, KiB |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for preset in presets:
            ways = [measure(place_tool, preset, a, b, pathlib.Path(folder))
                    for a, b in ((first, second), (second, first))]
            cells = [f"`{preset}`"]
            cells += [f"{100 * way['average_rate']:.1f} %" for way in ways]
            cells += [", ".join(f"{1e3 / way['latency_ms']['p50']:.0f}" for way in ways)]
            cells += [", ".join(str(way["support_vectors"]) for way in ways)]
            cells += [", ".join(f"{way['model_bytes'] / 1024:.0f}" for way in ways)]
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
