"""Runs place_recognizer with its own roscore and node_benchmark."""
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time

from measure import Failed, call

VECTORS = 500
PACED = (1200, 60)  # frames, a second


def free_port():
    with socket.socket() as probe:
        probe.bind(('', 0))
        return probe.getsockname()[1]


class Node:
    """A context manager: a roscore and a recognizer with the default preset."""

    def __init__(self, programs, recognizer):
        self.programs, self.recognizer = programs, recognizer
        self.home = tempfile.TemporaryDirectory()
        self.processes = []
        self.environment = dict(programs.environment, ROS_HOME=self.home.name, ROS_IP='127.0.0.1',
                                ROS_MASTER_URI=f'http://127.0.0.1:{free_port()}')

    def start(self, *command):
        self.processes.append(subprocess.Popen(
            [str(word) for word in command], env=self.environment, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL))
        return self.processes[-1]

    def __enter__(self):
        if not shutil.which('roscore') or not self.recognizer.exists():
            raise Failed('skipped: no roscore, or the node was not built')
        models = os.path.join(self.home.name, 'place_recognition', 'models')
        call([self.programs.path('write_model'), VECTORS, os.path.join(models, 'rooms.places')],
             env=self.environment)
        self.start('roscore', '-p', self.environment['ROS_MASTER_URI'].rsplit(':', 1)[1])
        time.sleep(5)
        self.node = self.start(self.recognizer, 'image:=/camera/image_raw', '_model:=rooms')
        time.sleep(3)
        return self

    def offer(self, frames, rate):
        return json.loads(call([self.programs.path('node_benchmark'), self.node.pid, frames, rate],
                               env=self.environment).splitlines()[-1])

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGINT)
            try:
                process.wait(15)
            except subprocess.TimeoutExpired:
                process.kill()
        self.home.cleanup()


def measure_node(programs, recognizer, long_frames):
    with Node(programs, recognizer) as node:
        return {'paced': node.offer(*PACED), 'long': node.offer(long_frames, 0)}
