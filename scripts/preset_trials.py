"""What the scripts share that train every preset and test it."""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

CONFIG = pathlib.Path(__file__).resolve().parent.parent / "config"


def parser(description):
    """Of a command line with the options below; `description`: its help, set as it is."""
    arguments = argparse.ArgumentParser(description=description,
                                        formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("runs", nargs=2, metavar="RUN")
    arguments.add_argument("--presets", help="names separated by commas; else all of config/")
    arguments.add_argument("--place-tool", help="path of the program; else through rosrun")
    return arguments


def presets(options):
    if options.presets:
        return options.presets.split(",")
    return sorted(path.stem for path in CONFIG.glob("*.yaml") if has_its_network(path))


def has_its_network(path):
    """Whether the networks that a configuration names are installed; says so if not."""
    home = pathlib.Path(os.environ.get("ROS_HOME") or pathlib.Path.home() / ".ros")
    for name in re.findall(r"^\s*network: *([\w-]+)", path.read_text(), re.MULTILINE):
        if not (home / "place_recognition/networks" / f"{name}.onnx").exists():
            print(f"{path.stem} is left out: there is no network '{name}' (doc/networks.md).",
                  file=sys.stderr)
            return False
    return True


class PlaceTool:
    """The program, as the command line says."""

    def __init__(self, options):
        self.command = ([options.place_tool] if options.place_tool
                        else ["rosrun", "place_recognition", "place_tool"])

    def figures(self, *words):
        """What a verb writes with --json."""
        result = subprocess.run([*self.command, *map(str, words), "--json", "-", "--progress",
                                 "none"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                universal_newlines=True)
        if result.returncode:
            sys.exit(result.stderr)
        out = result.stdout
        return json.loads(out[out.rindex("\n{") if "\n{" in out else 0:])

    def train(self, preset, run, model):
        return self.figures("train", run, "--model", model, "--config", CONFIG / f"{preset}.yaml")
