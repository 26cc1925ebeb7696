#!/usr/bin/env python3
"""Checks that the benchmark programs have the benchmarks that scripts/benchmark expects.

benchmark_rows_test.py FOLDER_OF_PROGRAMS

Nothing is measured. Programs that were not built because a library is missing are ignored. Exits
with 77 (skipped) if no program was built.
"""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'benchmark'))

import growth  # noqa: E402
from measure import Failed  # noqa: E402
from rows import ROWS  # noqa: E402


class AskedFor:
    """Stands in for the context of rows and its programs; records the benchmarks requested."""

    def __init__(self):
        self.benchmarks = set()
        self.programs = self

    def milliseconds(self, program, name):
        self.benchmarks.add((program, name))
        return 1

    def counter(self, program, name, _counter):
        return self.milliseconds(program, name)

    def path(self, program):
        raise Failed(f'{program} is not run')

    def node_figures(self, _run):
        raise Failed('the node is not run')


def listed(program):
    out = subprocess.run([str(program), '--benchmark_list_tests=true'], check=True,
                         stdout=subprocess.PIPE, universal_newlines=True).stdout
    return {name[:-len('/manual_time')] if name.endswith('/manual_time') else name
            for name in out.split()}


def main():
    folder = pathlib.Path(sys.argv[1])
    asked = AskedFor()
    for rows in ROWS.values():
        for row in rows:
            row.measure(asked)
    kinds = {('growth_benchmark', kind) for kind in growth.PANELS}
    programs = {program for program, _ in asked.benchmarks | kinds if (folder / program).exists()}
    names = {program: listed(folder / program) for program in programs}
    missing = [f'{program} has no {name}' for program, name in sorted(asked.benchmarks)
               if program in names and name not in names[program]]
    missing += [f'{program} has no {kind}' for program, kind in sorted(kinds)
                if program in names and not any(name.split('/')[0] == kind
                                                for name in names[program])]
    print('\n'.join(missing) or f'{len(asked.benchmarks)} benchmarks of {len(programs)} programs')
    return 1 if missing else 0 if programs else 77


if __name__ == '__main__':
    sys.exit(main())
