#!/usr/bin/env python3
"""Checks that training and its peer in benchmark/training_peer.py have the same results.

training_peer_test.py FOLDER_OF_PROGRAMS

Exits with 77 (skipped) without the program, scikit-learn or real images.
"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

IMAGES = 100
PEER = pathlib.Path(__file__).resolve().parents[2] / 'benchmark/training_peer.py'


def main():
    program = pathlib.Path(sys.argv[1]) / 'training_benchmark'
    images = pathlib.Path(os.environ.get('PLACE_RECOGNITION_TEST_DATA', '')) / 'ie_rooms'
    if not (program.exists() and images.is_dir() and importlib.util.find_spec('sklearn')):
        print(f'skipped: {program}, {images} or python3-sklearn is missing')
        return 77
    environment = dict(os.environ, PLACE_RECOGNITION_PICTURES=str(images))
    with tempfile.TemporaryDirectory() as folder:
        for command in ([program, 'write', folder, str(IMAGES)], [program, 'run', folder],
                        [sys.executable, PEER, folder]):
            subprocess.run([str(word) for word in command], env=environment, check=True)
    return 0


if __name__ == '__main__':
    sys.exit(main())
