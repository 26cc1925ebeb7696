"""Shared code of the tests of place_tool: running it, painted rooms, and recorded bags."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import cv2
import numpy as np

PLACE_TOOL = os.environ["PLACE_TOOL"]
SOURCE = pathlib.Path(os.environ["PLACE_RECOGNITION_SOURCE_DIR"])

# The colours of each room's walls and floor, BGR.
ROOMS = {"kitchen": ((60, 200, 220), (90, 60, 40)),
         "corridor": ((200, 190, 180), (120, 120, 130)),
         "office": ((120, 160, 60), (40, 80, 140))}


def paint(room, view, seed=0):
    """Returns an image of a room, CV_8UC3: wall, floor, a few objects, noise."""
    wall, floor = ROOMS[room]
    random = np.random.default_rng([seed, view, sorted(ROOMS).index(room)])
    image = np.zeros((96, 128, 3), np.float64)
    image[:60], image[60:] = wall, floor
    for _ in range(4):
        x, y = random.integers(0, 100), random.integers(0, 70)
        image[y:y + 20, x:x + 14] = np.roll(wall, 1) + random.integers(-10, 10)
    image += random.normal(0, 6, image.shape)
    return np.clip(image, 0, 255).astype(np.uint8)


class ToolCase(unittest.TestCase):
    """A test in a scratch folder, which is the tool's working directory."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="place_tool_test_")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.extra_environment = {}

    def environment(self):
        return dict(os.environ, ROS_HOME=str(self.folder / "ros_home"), **self.extra_environment)

    def run_tool(self, *arguments):
        return subprocess.run([PLACE_TOOL, *map(str, arguments)], cwd=self.folder, text=True,
                              env=self.environment(), capture_output=True, timeout=120)

    def succeed(self, *arguments):
        """Runs the tool; returns its stdout."""
        result = self.run_tool(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def figures(self, *arguments):
        """Runs the tool with --json -; returns the object, the only output on stdout."""
        return json.loads(self.succeed(*arguments, "--json", "-"))

    def refuse(self, *arguments, status=1):
        """Runs the tool, which must fail and leave no file behind; returns its one line."""
        before = self.files()
        result = self.run_tool(*arguments)
        self.assertEqual(result.returncode, status, result.stderr)
        lines = self.without_progress(result.stderr)
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith(f"place_tool {arguments[0]}"), lines[0])
        self.assertEqual(self.files(), before)
        return lines[0]

    def without_progress(self, said):
        """Returns stderr without lines on progress, which a busy machine may add."""
        return [line for line in said.splitlines() if not re.search(r": \d+ %(, .* left)?$", line)]

    def files(self):
        """Returns the contents of the scratch folder except what ROS keeps beside its logs."""
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*")
                      if not path.match("ros_home") and not path.match("rospack_cache*"))

    def write_image(self, path, image):
        target = self.folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        self.assertTrue(cv2.imwrite(str(target), image))
        return target

    def install_network(self, name="mobilenet"):
        """Installs a small network for `--config embedding`: a convolution, ReLU and the mean.
        Skips the test if python3-onnx is missing."""
        try:
            from onnx import TensorProto, helper, numpy_helper
        except ImportError:
            self.skipTest("python3-onnx is not installed")
        weights = np.random.default_rng(3).normal(size=(8, 3, 5, 5)).astype(np.float32)
        graph = helper.make_graph(
            [helper.make_node("Conv", ["image", "w"], ["map"], "first", strides=[16, 16],
                              kernel_shape=[5, 5]),
             helper.make_node("Relu", ["map"], ["positive"], "rectified"),
             helper.make_node("GlobalAveragePool", ["positive"], ["mean"], "pooled"),
             helper.make_node("Flatten", ["mean"], ["flat"], "flat")], "small",
            [helper.make_tensor_value_info("image", TensorProto.FLOAT, [1, 3, 32, 32])],
            [helper.make_tensor_value_info("flat", TensorProto.FLOAT, [1, 8])],
            [numpy_helper.from_array(weights, "w")])
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 9)])
        model.ir_version = 6
        path = self.folder / f"ros_home/place_recognition/networks/{name}.onnx"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(model.SerializeToString())
        return path

    def write_run(self, name, views=8, seed=0, rooms=tuple(ROOMS)):
        """Writes a folder of room/image."""
        for room in rooms:
            for view in range(views):
                self.write_image(f"{name}/{room}/{view:03d}.png", paint(room, view, seed))
        return name

    def write_bag(self, name, frames):
        """Writes a bag of JPEG images; `frames`: (room or None, label or None), one per second."""
        import rosbag
        import rospy
        from sensor_msgs.msg import CompressedImage
        from std_msgs.msg import String
        path = self.folder / name
        with rosbag.Bag(str(path), "w") as bag:
            for i, (room, label) in enumerate(frames):
                stamp = rospy.Time(1000 + i)
                if label is not None:
                    bag.write("/place_label", String(label), stamp)
                if room is not None:
                    image = CompressedImage(format="jpeg")
                    image.header.stamp = stamp
                    image.data = cv2.imencode(".jpg", paint(room, i))[1].tobytes()
                    bag.write("/camera/image_raw/compressed", image, stamp)
        return name
