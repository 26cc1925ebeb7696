#!/usr/bin/env python3
"""Tests the cue `embedding`: a network by name, in a model, and refused networks."""
import functools
import hashlib
import http.server
import json
import shutil
import signal
import socket
import subprocess
import threading
import time
import unittest

from tool_case import PLACE_TOOL, ToolCase


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class NetworkTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.network = self.install_network()

    def test_a_model_carries_its_network_and_learns_on(self):
        self.write_run("monday")
        self.write_run("tuesday", seed=1)
        before = self.figures("train", "monday", "--model", "./home.places", "--config",
                              "embedding")
        self.network.unlink()
        self.assertGreater(self.figures("evaluate", "--model", "./home.places",
                                        "tuesday")["average_rate"], 0.9)
        after = self.figures("train", "tuesday", "--add-to", "./home.places", "--model",
                             "./later.places")
        self.assertEqual(before["images"], after["images"])
        self.succeed("reduce", "--model", "./later.places", "--out", "./small.places", "--method",
                     "shared-greedy", "--support-vectors", "3")
        self.assertGreater(self.figures("evaluate", "--model", "./small.places",
                                        "tuesday")["average_rate"], 0.9)

    def test_the_same_bytes_whatever_the_number_of_threads(self):
        self.write_run("monday")
        for threads in (1, 3):
            self.succeed("train", "monday", "--model", f"./{threads}.places", "--config",
                         "embedding", "--threads", threads)
        self.assertEqual((self.folder / "1.places").read_bytes(),
                         (self.folder / "3.places").read_bytes())

    def test_what_cannot_be_used_is_refused_in_one_line(self):
        self.write_run("monday")
        train = ("train", "monday", "--model", "./home.places", "--config", "embedding")
        whole = self.network.read_bytes()
        self.network.write_bytes(whole[:len(whole) // 2])
        self.assertIn("mobilenet.onnx", self.refuse(*train))
        self.network.write_bytes(b"no network at all")
        self.assertIn("is not an ONNX file", self.refuse(*train))
        self.network.write_bytes(whole)
        self.assertIn("'absent'", self.refuse(*train, "--set", "cues.embedding.feature.layer=absent"))
        shutil.rmtree(self.network.parent)
        self.assertIn("place_tool network add FILE --name mobilenet", self.refuse(*train))

    def test_the_line_names_file_layer_and_version_before_an_image_is_read(self):
        self.network.write_bytes(self.network.read_bytes()[:-1])
        line = self.refuse("train", "no_such_run", "--model", "./home.places", "--config",
                           "embedding", "--set", "cues.embedding.feature.layer=pooled")
        self.assertIn("mobilenet.onnx", line)
        self.assertIn("layer 'pooled'", line)
        self.assertRegex(line, r"OpenCV \d+\.\d+\.\d+")

    def replace_the_program_that_tries_it(self, text):
        tools = self.folder / "libexec"
        tools.mkdir()
        (tools / "place_tool").write_text(text)
        (tools / "place_tool").chmod(0o755)
        self.extra_environment = {"PLACE_RECOGNITION_LIBEXEC": str(tools)}

    def test_a_program_that_cannot_be_started_is_no_fault_of_the_network(self):
        self.write_run("monday")
        self.replace_the_program_that_tries_it("")
        self.assertIn("The program place_tool of place_recognition cannot be started; build or install",
                      self.refuse("train", "monday", "--model", "./home.places", "--config", "embedding"))

    def test_a_network_that_ends_the_process_that_tries_it_is_refused(self):
        self.write_run("monday")
        self.replace_the_program_that_tries_it("#!/bin/sh\nkill -SEGV $$\n")
        line = self.refuse("train", "monday", "--model", "./home.places", "--config", "embedding")
        self.assertIn("mobilenet.onnx", line)
        self.assertIn("Segmentation fault", line)
        self.assertRegex(line, r"its output, OpenCV \d+\.\d+")


class InstallTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.network = self.install_network()
        self.given = self.network.rename(self.folder / "given.onnx")
        self.checksum = hashlib.sha256(self.given.read_bytes()).hexdigest()

    def serve(self):
        """Serves the test's folder on a separate server. Returns its address."""
        handler = functools.partial(QuietHandler, directory=str(self.folder))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        return f"http://127.0.0.1:{server.server_port}"

    def test_a_file_is_installed_and_listed(self):
        self.assertIn("There is no network", self.succeed("network", "list"))
        added = self.figures("network", "add", "given.onnx", "--name", "small", "--sha256",
                             self.checksum.upper())
        self.assertEqual(added["sha256"], self.checksum)
        self.assertEqual([added[key] for key in ("channels", "width", "height", "dimension")],
                         [3, 32, 32, 8])
        self.assertEqual((self.network.parent / "small.onnx").read_bytes(),
                         self.given.read_bytes())
        (self.network.parent / "broken.onnx").write_bytes(b"no network")
        broken, small = self.figures("network", "list")["networks"]
        self.assertIn("is not an ONNX file", broken["problem"])
        self.assertEqual(small, added)

    @unittest.skipUnless(shutil.which("curl"), "curl is not installed")
    def test_a_network_is_downloaded_only_when_asked(self):
        address = self.serve()
        self.figures("network", "add", f"{address}/given.onnx", "--name", "small", "--sha256",
                     self.checksum)
        self.assertEqual((self.network.parent / "small.onnx").read_bytes(),
                         self.given.read_bytes())
        line = self.refuse("network", "add", f"{address}/absent.onnx", "--name", "other")
        self.assertIn(f"{address}/absent.onnx", line)
        self.assertIn("404", line)

    def start_adding(self, source, *arguments):
        process = subprocess.Popen([PLACE_TOOL, "network", "add", source, "--name", "small",
                                    *arguments], cwd=self.folder, env=self.environment(), text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def check_that_it_stops(self, process):
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=10)
        self.assertEqual(process.returncode, 130)
        self.assertFalse(self.network.parent.exists() and list(self.network.parent.iterdir()))

    @unittest.skipUnless(shutil.which("curl"), "curl is not installed")
    def test_a_download_that_stalls_can_be_stopped(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            process = self.start_adding(f"http://127.0.0.1:{server.getsockname()[1]}/x.onnx")
            server.settimeout(30)
            connection, _ = server.accept()
            with connection:
                connection.recv(1 << 16)
                connection.sendall(b"HTTP/1.1 200 OK\r\nContent-Length: 9000\r\n\r\n" + bytes(100))
                self.check_that_it_stops(process)
                connection.settimeout(10)
                try:
                    self.assertEqual(connection.recv(1), b"")  # curl has ended, too
                except ConnectionResetError:
                    pass  # before it had read all

    def start_a_trial(self, then, *arguments):
        """Starts an installation whose trial runs the shell command `then`. Returns its process."""
        trial = self.folder / "libexec/place_tool"
        trial.parent.mkdir()
        trial.write_text(f"#!/bin/sh\ntouch {self.folder}/started\n{then}\n")
        trial.chmod(0o755)
        self.extra_environment = {"PLACE_RECOGNITION_LIBEXEC": str(trial.parent)}
        process = self.start_adding("given.onnx", *arguments)
        self.extra_environment = {}
        while not (self.folder / "started").exists():
            time.sleep(.05)
        return process

    def test_a_trial_can_be_stopped(self):
        self.check_that_it_stops(self.start_a_trial("exec sleep 30"))

    def test_two_installations_of_one_name_do_not_mix(self):
        go_on = self.folder / "go_on"
        first = self.start_a_trial(
            f'while [ ! -e {go_on} ]; do sleep .05; done; exec {PLACE_TOOL} "$@"', "--json", "-")
        producer_name = b"\x12\x05other"  # a field of the network that changes its bytes
        (self.folder / "other.onnx").write_bytes(self.given.read_bytes() + producer_name)
        self.succeed("network", "add", "other.onnx", "--name", "small")
        go_on.touch()
        output, errors = first.communicate(timeout=30)
        self.assertEqual(first.returncode, 0, errors)
        self.assertEqual(json.loads(output)["sha256"], self.checksum)
        self.assertEqual((self.network.parent / "small.onnx").read_bytes(),
                         self.given.read_bytes())
        self.assertEqual(len(list(self.network.parent.iterdir())), 1)

    def test_unintended_and_invalid_files_are_not_installed(self):
        line = self.refuse("network", "add", "given.onnx", "--name", "small", "--sha256", "0" * 64)
        self.assertIn(self.checksum, line)
        self.network.parent.mkdir(parents=True, exist_ok=True)
        (self.folder / "bad.onnx").write_bytes(self.given.read_bytes()[:100])
        line = self.refuse("network", "add", "bad.onnx", "--name", "small")
        self.assertIn("bad.onnx", line)
        self.assertNotIn(".small", line)
        self.assertEqual(list(self.network.parent.iterdir()), [])
        self.assertIn("'absent'", self.refuse("network", "add", "given.onnx", "--name", "small",
                                              "--layer", "absent"))
        for name in ("../small", "--help", "-h", "--", "-x"):
            self.refuse("network", "add", "given.onnx", f"--name={name}", status=2)

    def test_a_file_whose_name_starts_with_a_dash_is_no_option(self):
        self.given.rename(self.folder / "--help.onnx")
        self.succeed("network", "add", "--name", "small", "--", "--help.onnx")
        self.write_run("monday")
        self.succeed("train", "monday", "--model", "home", "--config", "embedding", "--set",
                     "cues.embedding.feature.network=--help.onnx", "--set",
                     "cues.layout.feature.network=--help.onnx")
        self.assertIn("cannot name a model", self.refuse("train", "monday", "--model=-home"))


if __name__ == "__main__":
    unittest.main()
