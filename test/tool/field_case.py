"""Shared code of the tests of inputs from the field: a small training, and bags with labels."""
import json
import os
import subprocess

import cv2
from tool_case import PLACE_TOOL, ToolCase, paint

MODEL = ("--model", "./home.places", "--config", "crfh_colour")
NOBODY = 65534


class FieldCase(ToolCase):
    def train(self, *inputs):
        """Trains; returns the figures and the output on stderr."""
        result = self.run_tool("train", *inputs, *MODEL, "--json", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), result.stderr

    def rooms_of(self, *inputs):
        return sorted(self.train(*inputs)[0]["rooms"])

    def assert_names(self, text, *words):
        for word in words:
            self.assertIn(word, text)

    def run_as_nobody(self, *arguments, stdout=subprocess.PIPE):
        """Runs the tool as an unprivileged user, who has full access to the scratch folder."""
        self.folder.chmod(0o777)
        return subprocess.run([PLACE_TOOL, *arguments], cwd=self.folder, text=True, timeout=120,
                              stdout=stdout, stderr=subprocess.PIPE, env=self.environment(),
                              preexec_fn=lambda: os.setuid(NOBODY))

    def write_labelled(self, name, start, frames, labels, topic="/place_label",
                       camera="/camera/image_raw", interval=1):
        """Writes a bag with a JPEG frame every `interval` s from `start`; `labels`: (s, text)."""
        import rosbag
        import rospy
        from sensor_msgs.msg import CompressedImage
        from std_msgs.msg import String
        with rosbag.Bag(str(self.folder / name), "w") as bag:
            for second, text in labels:
                bag.write(topic, String(text), rospy.Time(start + second))
            for i, room in enumerate(frames):
                stamp = rospy.Time(start + i * interval)
                image = CompressedImage(format="bgr8; jpeg compressed bgr8")
                image.header.stamp = stamp
                image.data = cv2.imencode(".jpg", paint(room, start % 100 + i))[1].tobytes()
                bag.write(camera + "/compressed", image, stamp)
        return name
