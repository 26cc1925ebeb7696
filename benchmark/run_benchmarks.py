#!/usr/bin/env python3
"""Compares this package with its peers; called by scripts/benchmark, which builds first.

Writes OUT/performance.md, OUT/performance.json and OUT/growth.svg; exits with 1 if a row could not
be measured, its result is not the peer's, or a goal is missed (--lenient: not for goals).
"""
import argparse
import functools
import importlib.util
import json
import os
import pathlib
import subprocess
import sys

import growth
from measure import Failed, Programs, describe_machine
from node_run import measure_node
from rows import ROWS

SOURCE = pathlib.Path(__file__).resolve().parent.parent


class Context:
    """What the rows need for their measurements."""

    def __init__(self, options, pictures):
        self.source, self.python = SOURCE, sys.executable
        environment = dict(os.environ, PLACE_RECOGNITION_PICTURES=str(pictures),
                           PLACE_RECOGNITION_TEST_DATA=str(options.data),
                           # One core: idle threads of OpenBLAS wait in a loop, which would count.
                           OMP_NUM_THREADS='1', OPENBLAS_NUM_THREADS='1')
        self.programs = Programs(options.build / 'benchmark/bin', environment, options.rounds)
        self.recognizer = options.build / 'devel/lib/place_recognition/place_recognizer'
        self.long_frames = options.long_frames

    @staticmethod
    def has_module(name):
        return importlib.util.find_spec(name) is not None

    @functools.lru_cache(maxsize=None)
    def _node(self):
        try:
            return measure_node(self.programs, self.recognizer, self.long_frames)
        except Failed as failure:
            return failure

    def node_figures(self, run):
        if isinstance(self._node(), Failed):
            raise self._node()
        return self._node()[run]


def find_pictures(options):
    """Images of real rooms or, if there are none, rendered ones."""
    real = options.data / 'ie_rooms'
    if real.is_dir():
        return real, 'photographs of ie_rooms'
    rendered = options.out / 'pictures'
    if not rendered.exists():
        place_tool = options.build / 'devel/lib/place_recognition/place_tool'
        subprocess.run([str(place_tool), 'simulate', '--out', str(rendered), '--conditions',
                        'cloudy', '--format', 'images'], check=True)
    return rendered, 'rendered rooms'


def in_words(row):
    figure = '-' if row['figure'] is None else f'{row["figure"]:.3g}'
    return [row['what'], row['peer'], figure, row['goal'], 'yes' if row['met'] else 'NO',
            row['detail']]


def table(rows):
    lines = ['| what | peer | figure | goal | met | made of |', '| --- ' * 6 + '|']
    return '\n'.join(lines + ['| ' + ' | '.join(in_words(row)) + ' |' for row in rows]) + '\n'


def write(options, machine, rows, points):
    text = '\n'.join(f'- {key}: {value}' for key, value in machine.items())
    (options.out / 'performance.md').write_text(text + '\n\n' + table(rows))
    (options.out / 'performance.json').write_text(
        json.dumps({'machine': machine, 'rows': rows, 'growth': points}, indent=2) + '\n')
    if points and Context.has_module('matplotlib'):
        growth.draw(points, options.out / 'growth.svg')


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--build', type=pathlib.Path, default=SOURCE / 'build')
    parser.add_argument('--out', type=pathlib.Path, help='default: BUILD/benchmark')
    parser.add_argument('--data', type=pathlib.Path, default=os.environ.get(
        'PLACE_RECOGNITION_TEST_DATA', SOURCE.parent / 'shared/data'),
        help='folder of real images, as for the tests; without it rooms are rendered')
    parser.add_argument('--rounds', type=int, default=7, help='interleaved runs of each row')
    parser.add_argument('--only', default=','.join([*ROWS, 'growth']),
                        help='some of these, separated by commas: %(default)s')
    parser.add_argument('--frames', type=int, default=2000,
                        help='of the longest training, up to 20000 (two minutes and 8 GB)')
    parser.add_argument('--long-frames', type=int, default=10000,
                        help='images for the memory of the node')
    parser.add_argument('--lenient', action='store_true', help='a missed goal is no failure')
    options = parser.parse_args()
    options.out = options.out or options.build / 'benchmark'
    options.data = pathlib.Path(options.data)
    return options


def main():
    options = parse_options()
    options.out.mkdir(parents=True, exist_ok=True)
    wanted = options.only.split(',')
    unknown = set(wanted) - {*ROWS, 'growth'}
    if unknown:
        sys.exit(f'There are no rows {", ".join(unknown)}; choose from {", ".join(ROWS)}, growth.')
    pictures, kind = find_pictures(options)
    machine = dict(describe_machine(options.build), pictures=kind, rounds=options.rounds)
    context = Context(options, pictures)

    rows, points = [], {}
    for name in wanted:
        if name == 'growth':
            more, points = growth.measure_growth(context.programs, options.frames)
        else:
            more = [row.measure(context) for row in ROWS[name]]
        print(table(more).split('\n', 2)[2], end='', flush=True)
        rows += more
    write(options, machine, rows, points)
    failed = [row for row in rows if row['figure'] is None and 'skipped' not in row['detail']]
    missed = [row for row in rows if row['figure'] is not None and not row['met']]
    print(f'{len(rows)} rows, {len(missed)} goals missed, {len(failed)} not measured: '
          f'{options.out / "performance.md"}')
    return 1 if failed or (missed and not options.lenient) else 0


if __name__ == '__main__':
    sys.exit(main())
