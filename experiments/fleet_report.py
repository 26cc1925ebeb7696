#!/usr/bin/env python3
"""Writes report.html and report.md on all buildings learned by fleet.smk: fleet_report.py OUT.

OUT contains BUILDING/training.json and, if the model was evaluated, BUILDING/evaluation.json, the
--json output of `place_tool train` and `evaluate`. The worst building comes first.
"""
import html
import json
import pathlib
import sys
import urllib.parse

COLUMNS = ("building", "places", "images", "support vectors", "model, KiB", "held out, right",
           "test, right", "calibration error", "'unknown'", "worst place")


def percent(fraction):
    return f"{100 * fraction:.1f} %"


def row(name, training, evaluation):
    """Returns the cells of one building. The cells on the test are empty if there was none."""
    validation = training["validation"]
    held_out = percent(validation["average_rate"]) if validation["rooms"] else ""
    cells = [name, str(len(training["rooms"])), str(training["images"]),
             str(training["support_vectors"]), f"{training['model_bytes'] / 1024:.0f}", held_out]
    if not evaluation:
        return cells + [""] * 4
    worst, figures = min(evaluation["rooms"].items(), key=lambda item: (item[1]["rate"], item[0]))
    return cells + [percent(evaluation["average_rate"]), f"{evaluation['calibration_error']:.3f}",
                    percent(evaluation["unknown_share"]), f"{worst} ({percent(figures['rate'])})"]


def read(out):
    """Returns [(row, warnings, whether there is a report)], by ascending rate; buildings without a
    test come last, by name."""
    buildings = []
    for path in sorted(out.glob("*/training.json")):
        training = json.loads(path.read_text(encoding="utf-8"))
        tested = path.with_name("evaluation.json")
        evaluation = json.loads(tested.read_text(encoding="utf-8")) if tested.is_file() else None
        rate = evaluation["average_rate"] if evaluation else 2
        warnings = training["warnings"] + (evaluation or {}).get("warnings", [])
        buildings.append((rate, row(path.parent.name, training, evaluation), warnings,
                          bool(evaluation)))
    buildings.sort(key=lambda building: (building[0], building[1][0]))
    return [building[1:] for building in buildings]


def markdown(buildings):
    lines = ["| " + " | ".join(COLUMNS) + " |", "|" + " --- |" * len(COLUMNS)]
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"
              for cells, _, _ in buildings]
    for cells, warnings, _ in buildings:
        lines += [f"\n**{cells[0]}**\n"] * bool(warnings) + [f"- {text}" for text in warnings]
    return "\n".join(lines) + "\n"


def page(buildings):
    rows = []
    for cells, warnings, has_report in buildings:
        texts = [html.escape(cell) for cell in cells]
        if has_report:
            address = urllib.parse.quote(f"{cells[0]}/report/report.html")
            texts[0] = f'<a href="{address}">{texts[0]}</a>'
        rows.append("<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>")
        rows += [f'<tr class="warning"><td></td><td colspan="{len(COLUMNS) - 1}">'
                 f"{html.escape(text)}</td></tr>" for text in warnings]
    head = "".join(f"<th>{html.escape(name)}</th>" for name in COLUMNS)
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Buildings</title>'
            "<style>body { font: 15px/1.5 sans-serif; margin: 2em } td, th { padding: 0.2em 0.8em; "
            "text-align: right } td:first-child, th:first-child, .warning td { text-align: left } "
            ".warning { color: #a50 }</style></head>\n<body><h1>Buildings</h1>\n<table>\n<tr>"
            + head + "</tr>\n" + "\n".join(rows) + "\n</table></body></html>\n")


def main():
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir():
        sys.exit("usage: fleet_report.py OUT, where OUT is the output folder of fleet.smk")
    out = pathlib.Path(sys.argv[1])
    buildings = read(out)
    if not buildings:
        sys.exit(f"fleet_report.py: {out} contains no BUILDING/training.json")
    for name, text in (("report.md", markdown(buildings)), ("report.html", page(buildings))):
        (out / name).write_text(text, encoding="utf-8", errors="surrogateescape")


if __name__ == "__main__":
    main()
