#!/usr/bin/env python3
"""Trains every preset of config/ on one run and tests it on another, both ways.

  . build/devel/setup.bash
  ./scripts/compare_presets.py RUN1 RUN2 [--presets crfh,sift] [--place-tool PATH]

Prints a Markdown table with, for each direction, the mean of the rooms' recognition rates, the
frames recognized per second, and the size of the model. RUN1 and RUN2 are bags or folders of
room/image files. No choice depends on the run that is tested on.
"""
import pathlib
import tempfile

from preset_trials import PlaceTool, parser, presets


def main():
    options = parser(__doc__).parse_args()
    place_tool = PlaceTool(options)
    first, second = options.runs
    print("| preset | forward | backward | frames per second | support vectors | model, KiB |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        model = pathlib.Path(folder) / "compared.places"
        for preset in presets(options):
            ways = []
            for train, test in ((first, second), (second, first)):
                place_tool.train(preset, train, model)
                ways.append(place_tool.figures("evaluate", test, "--model", model))
            cells = [f"`{preset}`"]
            cells += [f"{100 * way['average_rate']:.1f} %" for way in ways]
            cells += [", ".join(f"{1e3 / way['latency_ms']['p50']:.0f}" for way in ways)]
            cells += [", ".join(str(way["support_vectors"]) for way in ways)]
            cells += [", ".join(f"{way['model_bytes'] / 1024:.0f}" for way in ways)]
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
