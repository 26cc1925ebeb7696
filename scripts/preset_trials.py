"""Shared code of the scripts that train and test every preset."""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

CONFIG = pathlib.Path(__file__).resolve().parent.parent / "config"


def parser(description):
    """Returns a parser of the common options; `description`: help text, printed verbatim."""
    arguments = argparse.ArgumentParser(description=description,
                                        formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("runs", nargs=2, metavar="RUN")
    arguments.add_argument("--presets", help="comma-separated names; default: all of config/")
    arguments.add_argument("--place-tool", help="path of place_tool; default: through rosrun")
    return arguments


def presets(options):
    if options.presets:
        return options.presets.split(",")
    return sorted(path.stem for path in CONFIG.glob("*.yaml") if has_its_network(path))


def has_its_network(path):
    """Returns whether the networks that a configuration names are installed; prints one that is
    missing."""
    home = pathlib.Path(os.environ.get("ROS_HOME") or pathlib.Path.home() / ".ros")
    for name in re.findall(r"^\s*network: *([\w-]+)", path.read_text(encoding="utf-8"), re.MULTILINE):
        if not (home / "place_recognition/networks" / f"{name}.onnx").exists():
            print(f"Skipping {path.stem}: the network '{name}' is not installed (doc/networks.md).",
                  file=sys.stderr)
            return False
    return True


class PlaceTool:
    """Runs place_tool as the command line selects it."""

    def __init__(self, options):
        self.command = ([options.place_tool] if options.place_tool
                        else ["rosrun", "place_recognition", "place_tool"])
        if not shutil.which(self.command[0]):
            sys.exit(f"{self.command[0]} is not a program; source build/devel/setup.bash first, or "
                     "give --place-tool.")

    def figures(self, *words):
        """Returns the JSON output of a verb."""
        result = subprocess.run([*self.command, *map(str, words), "--json", "-", "--progress",
                                 "none"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                encoding="utf-8", errors="replace")
        if result.returncode:
            sys.exit(result.stderr)
        out = result.stdout
        return json.loads(out[out.rindex("\n{") if "\n{" in out else 0:])

    def train(self, preset, run, model):
        return self.figures("train", run, "--model", model, "--config", CONFIG / f"{preset}.yaml")
