"""What the scripts share that train every preset and test it."""
import argparse
import json
import pathlib
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
    return sorted(path.stem for path in CONFIG.glob("*.yaml"))


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
