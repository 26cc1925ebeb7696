"""Shared code of tests that train a model and show images to nodes."""
import os

import rosbag
import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String

from node_case import Camera, NodeCase, paint

IMAGE = "image:=/camera/image_raw"
ROOMS = "places: [{name: kitchen, position: [[0, 0], [4, 0], [4, 3]]}]"
TOOL = os.environ["PLACE_TOOL"]


class FieldCase(NodeCase):
    def camera(self, *arguments, **options):
        camera = Camera(*arguments, **options)
        self.addCleanup(camera.close)
        return camera

    def listen(self, topic, type_):
        """Collects the messages of a topic from now on."""
        heard = []
        subscriber = rospy.Subscriber(topic, type_, heard.append)
        self.addCleanup(subscriber.unregister)
        self.wait_for(subscriber.get_num_connections, f"nobody publishes {topic}")
        return heard

    def write_run(self, name):
        """Writes a labelled bag of two rooms."""
        with rosbag.Bag(str(self.folder / name), "w") as bag:
            for i in range(16):
                room = ("kitchen", "office")[i // 8]
                stamp = rospy.Time(1000 + i)
                if i % 8 == 0:
                    bag.write("/place_label", String(room), stamp)
                image = Image(height=96, width=128, encoding="bgr8", step=384,
                              data=paint(room, i).tobytes())
                image.header.stamp = stamp
                bag.write("/image", image, stamp)
        return name

    def train(self, run, model="home"):
        program = self.start(TOOL, "train", run, "--model", model, "--config", "crfh_colour")
        self.assertEqual(program.wait(), 0, program.output)
        return model
