# Trains a model for each of many buildings and writes one report on all of them.
#
#   snakemake -s experiments/fleet.smk --cores all --config buildings=site out=fleet
#   snakemake -s experiments/fleet.smk --profile experiments/slurm --config buildings=site out=fleet
#
# `buildings` contains a folder per building: BUILDING/train with the recordings to learn (bags, or
# folders of room/image), and optionally BUILDING/test with the recordings to evaluate the model on.
# `out` receives models/BUILDING.places, BUILDING/report/report.html and, for all buildings,
# report.html and report.md. It must be on a disk that all machines share. A job that is killed is
# restarted.
# --config:
#   config   preset or YAML file for `train`; default: that of `train`
#   tune     1: first search for a configuration for each building, which is slow
#   parts    number of jobs that share the search for a building; jobs beyond 8 may be idle
#   search   further options for `tune`, such as "--same-light"
#   options  further options for `train`, such as "--set sampling.rate=5"
#   tool     path of place_tool; default: through rosrun

import shlex
from pathlib import Path

BUILDINGS, OUT = Path(config["buildings"]), config["out"]
TOOL, OPTIONS = config.get("tool", "rosrun place_recognition place_tool"), config.get("options", "")
TUNE = str(config.get("tune", "0")) not in ("0", "no", "false", "False")
PARTS, SEARCH = int(config.get("parts", 4)), config.get("search", "")
REPORT = Path(workflow.basedir) / "fleet_report.py"

names = sorted(folder.name for folder in BUILDINGS.iterdir() if (folder / "train").is_dir())
if not names:
    raise SystemExit(f"{BUILDINGS} contains no BUILDING/train folder with recordings.")
tested = [name for name in names if (BUILDINGS / name / "test").is_dir()]


def recordings(wildcards):
    return BUILDINGS / wildcards.name / "train"


def configuration(wildcards):
    return [f"{OUT}/{wildcards.name}/tuned.yaml"] if TUNE else []


def configured(wildcards, input):
    chosen = input[0] if input else config.get("config")
    return f"--config {shlex.quote(chosen)}" if chosen else ""


wildcard_constraints:
    name="[^/]+",
    part="[0-9]+",


localrules: all, report


rule all:
    input: OUT + "/report.html"


# The parts store their results in the folder `cells` beside them.
rule search:
    output: touch(OUT + "/{name}/search/{part}")
    params:
        runs=recordings,
        cells=OUT + "/{name}/search/cells",
        tuned=OUT + "/{name}/tuned.yaml",
    threads: 2
    retries: 3
    shell:
        "{TOOL} tune {params.runs:q} --out {params.tuned:q} --cells {params.cells:q} {SEARCH}"
        " --part {wildcards.part}/{PARTS} --threads {threads} --progress none"


rule tune:
    input: [OUT + "/{name}/search/" + str(part) for part in range(1, PARTS + 1)]
    output: OUT + "/{name}/tuned.yaml"
    params:
        runs=recordings,
        cells=OUT + "/{name}/search/cells",
    threads: 2
    retries: 3
    shell:
        "{TOOL} tune {params.runs:q} --out {output:q} --cells {params.cells:q} {SEARCH}"
        " --threads {threads} --progress none"


rule train:
    input: configuration
    output:
        model=OUT + "/models/{name}.places",
        figures=OUT + "/{name}/training.json",
    params:
        runs=recordings,
        configured=configured,
    threads: 2
    retries: 3
    shell:
        "{TOOL} train {params.runs:q} --model {output.model:q} --json {output.figures:q}"
        " {params.configured} {OPTIONS} --threads {threads} --progress none"


rule evaluate:
    input: OUT + "/models/{name}.places"
    output:
        figures=OUT + "/{name}/evaluation.json",
        report=directory(OUT + "/{name}/report"),
    params: runs=lambda wildcards: BUILDINGS / wildcards.name / "test"
    retries: 3
    shell:
        "{TOOL} evaluate --model {input:q} {params.runs:q} --json {output.figures:q}"
        " --report {output.report:q} --progress none"


rule report:
    input:
        expand(OUT + "/{name}/training.json", name=names),
        expand(OUT + "/{name}/evaluation.json", name=tested),
    output: OUT + "/report.html", OUT + "/report.md"
    params: script=REPORT
    shell: "python3 {params.script:q} {OUT:q}"
