"""Runs the benchmark programs repeatedly, interleaved, and takes medians."""
import json
import os
import pathlib
import platform
import statistics
import subprocess

MILLISECONDS = {'ns': 1e-6, 'us': 1e-3, 'ms': 1, 's': 1e3}


class Failed(Exception):
    """A benchmark failed to run, or its result differs from the peer's."""


def call(command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, **options)
    if done.returncode != 0:
        last_lines = (done.stderr + done.stdout).strip().splitlines()[-1:]
        raise Failed(f'{pathlib.Path(str(command[0])).name}: {" ".join(last_lines)}')
    return done.stdout


class Programs:
    """The google-benchmark programs of a build. Each is run once, on first use."""

    def __init__(self, folder, environment, rounds):
        self.folder, self.environment, self.rounds = folder, environment, rounds
        self.runs = {}

    def path(self, program):
        path = self.folder / program
        if not path.exists():
            raise Failed(f'{program} was not built; the log of cmake says why')
        return path

    def _run(self, program):
        if program not in self.runs:
            out = call([self.path(program), '--benchmark_format=json',
                        f'--benchmark_repetitions={self.rounds}', '--benchmark_min_time=0.05',
                        '--benchmark_enable_random_interleaving=true'], env=self.environment)
            self.runs[program] = [run for run in json.loads(out[out.index('{'):])['benchmarks']
                                  if run['run_type'] == 'iteration']
        return self.runs[program]

    def names(self, program):
        return list(dict.fromkeys(run['name'] for run in self._run(program)))

    def repetitions(self, program, name):
        runs = [run for run in self._run(program)
                if run['name'] == name or run['name'] == name + '/manual_time']
        for run in runs:
            if run.get('error_occurred'):
                raise Failed(run['error_message'])
        if not runs:
            raise Failed(f'{program} has no {name}')
        return runs

    def milliseconds(self, program, name):
        """Median processor time, the figure least affected by other programs."""
        def time(run):
            manual = run['name'].endswith('/manual_time')
            return run['real_time' if manual else 'cpu_time'] * MILLISECONDS[run['time_unit']]
        return statistics.median(time(run) for run in self.repetitions(program, name))

    def counter(self, program, name, counter):
        return statistics.median(run[counter] for run in self.repetitions(program, name))


def describe_machine(build):
    def first_line(command):
        return call(command).splitlines()[0]

    cpu = dict(line.split(':', 1) for line in call(['lscpu']).splitlines() if ':' in line)
    flags = cpu.get('Flags', '').split()
    vectors = [flag for flag in ('avx2', 'avx512f', 'avx512_vnni', 'asimd') if flag in flags]
    cache = (build / 'CMakeCache.txt').read_text()
    compiler = next(line.split('=', 1)[1] for line in cache.splitlines()
                    if line.startswith('CMAKE_CXX_COMPILER:'))
    memory = os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 2**30
    return {'processor': cpu.get('Model name', platform.machine()).strip(),
            'cores': os.cpu_count(), 'vectors': ' '.join(vectors),
            'memory_gib': round(memory, 1), 'system': platform.platform(),
            'compiler': first_line([compiler, '--version']),
            'load_at_start': round(os.getloadavg()[0], 1)}
