#!/usr/bin/env python3
"""Measures how well places that were never trained are distinguished from trained ones.

  . build/devel/setup.bash
  ./scripts/leave_rooms_out.py RUN1 RUN2 [--elsewhere RUN3] [--presets crfh,sift]
                               [--place-tool PATH]

For every preset, trains on one run without each room of the other run in turn and tests on the
other run, in both directions. Prints a Markdown table of the means over the rooms: the area under
the ROC curve of known against unknown and, at the threshold that `train` sets, the fractions of
unknown and known images that are answered 'unknown'. --elsewhere adds a row for a run from another
building, with all rooms trained. The runs are folders of room/image files.
"""
import pathlib
import sys
import tempfile

from preset_trials import PlaceTool, parser, presets

KEYS = ("roc_area", "detection_rate", "false_alarm_rate")


def room_folders(run):
    """Returns the folders of a run's rooms, without those that other systems add."""
    folder = pathlib.Path(run)
    if not folder.is_dir():
        sys.exit(f"{run} is not a folder; give a folder of room/image files.")
    return [path for path in sorted(folder.iterdir()) if path.is_dir()
            and not path.name.startswith((".", "@", "__")) and path.name != "lost+found"]


def mean_cells(results):
    """Returns the cells with the means of the results; None is one without known or without unknown
    images."""
    results = [result for result in results if result]
    if not results:
        return ["-"] * len(KEYS)
    means = [sum(result[key] for result in results) / len(results) for key in KEYS]
    return [f"{means[0]:.3f}", f"{100 * means[1]:.0f} %", f"{100 * means[2]:.0f} %"]


class Trial:
    def __init__(self, place_tool, preset, folder):
        self.place_tool, self.preset, self.folder = place_tool, preset, pathlib.Path(folder)

    def without(self, room, run, *tests):
        """Trains on all rooms of `run` except `room` and returns the figures of the tests."""
        with tempfile.TemporaryDirectory(dir=self.folder) as rest:
            for other in room_folders(run):
                if other.name != room:
                    (pathlib.Path(rest) / other.name).symlink_to(other.resolve())
            model = self.folder / "rest.places"
            self.place_tool.train(self.preset, rest, model)
            return self.place_tool.figures("evaluate", *tests, "--model", model)["unknown"]


def main():
    arguments = parser(__doc__)
    arguments.add_argument("--elsewhere", metavar="RUN", help="a run in other places")
    options = arguments.parse_args()
    place_tool = PlaceTool(options)
    first, second = options.runs
    rooms = {run: [path.name for path in room_folders(run)] for run in options.runs}
    print("| preset | unknown | area, forward | detected | false alarms "
          "| area, backward | detected | false alarms |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for preset in presets(options):
            trial = Trial(place_tool, preset, folder)
            cells = [f"`{preset}`", "a room"]
            for train, test in ((first, second), (second, first)):
                cells += mean_cells([trial.without(room, train, test) for room in rooms[test]])
            print("| " + " | ".join(cells) + " |", flush=True)
            if not options.elsewhere:
                continue
            cells = [f"`{preset}`", "elsewhere"]
            for train, test in ((first, second), (second, first)):
                cells += mean_cells([trial.without(None, train, test, options.elsewhere)])
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
