#!/usr/bin/env python3
"""Checks that the benchmark programs run: each benchmark once, on the real rooms.

benchmark_runs_test.py FOLDER_OF_PROGRAMS

Nothing is measured. Programs that were not built because a library is missing are ignored. Exits
with 77 (skipped) if no program was built, or without $PLACE_RECOGNITION_TEST_DATA.
"""
import json
import os
import pathlib
import subprocess
import sys

PROGRAMS = ('crfh', 'cues', 'kernel', 'local_features', 'local_match', 'model_load', 'reduction')


def problem_of(program, rooms):
    """Returns what went wrong, or an empty text."""
    environment = dict(os.environ, PLACE_RECOGNITION_PICTURES=str(rooms))
    run = subprocess.run([str(program), '--benchmark_min_time=1e-9', '--benchmark_format=json'],
                         env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                         universal_newlines=True)
    if run.returncode:
        return f'ended with {run.returncode}: {run.stderr[-500:]}'
    results = json.loads(run.stdout)['benchmarks']
    errors = [f"{result['name']}: {result['error_message']}" for result in results
              if result.get('error_occurred')]
    return '; '.join(errors) if results else 'has no benchmark'


def main():
    programs = [pathlib.Path(sys.argv[1]) / f'{name}_benchmark' for name in PROGRAMS]
    programs = [program for program in programs if program.exists()]
    rooms = pathlib.Path(os.environ.get('PLACE_RECOGNITION_TEST_DATA', '')) / 'ie_rooms/clip1'
    if not programs or not rooms.is_dir():
        print(f'{len(programs)} programs were built; the rooms are expected in {rooms}: skipped')
        return 77
    failed = False
    for program in programs:
        problem = problem_of(program, rooms)
        print(f"{program.name}: {problem or 'runs'}", flush=True)
        failed = failed or bool(problem)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
