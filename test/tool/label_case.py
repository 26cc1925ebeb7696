"""Shared code of the tests of place_tool label: bags of many kinds of images, and the server."""
import http.client
import json
import signal
import subprocess
import urllib.parse

import cv2
import numpy as np
import rosbag
import rospy
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import String
from tool_case import PLACE_TOOL, ToolCase

START = 1700000000.5
TOPIC = "/camera/image_raw/compressed"
# A locale that is not UTF-8, as an 8-bit one is; every system has this one.
IN_ASCII = {"LC_ALL": "POSIX", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}


def jpeg(number, size=(48, 64)):
    """Returns an image whose brightness encodes its number."""
    image = np.full((*size, 3), number % 200 + 28, np.uint8)
    message = CompressedImage(format="bgr8; jpeg compressed bgr8")
    message.data = cv2.imencode(".jpg", image)[1].tobytes()
    return message


def raw(image, encoding, padding=0):
    """Returns a message with `padding` bytes after each row."""
    rows = image.reshape(image.shape[0], -1).view(np.uint8)
    rows = np.pad(rows, ((0, 0), (0, padding)), constant_values=255)
    return Image(height=image.shape[0], width=image.shape[1], encoding=encoding,
                 step=rows.shape[1], data=rows.tobytes())


class Page:
    """A running `place_tool label` and the requests that a browser would send."""

    def __init__(self, folder, environment, *arguments):
        self.process = subprocess.Popen(
            [PLACE_TOOL, "label", "--no-browser", *map(str, arguments)], cwd=folder,
            errors="surrogateescape", env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        line = self.process.stdout.readline()
        self.address = line.split(" ")[-1].strip()
        parts = urllib.parse.urlsplit(self.address)
        self.port, self.path = parts.port, parts.path

    def request(self, method, name, body=None, **headers):
        """Returns the response's status and content. A `name` that starts with / is a full path."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        if method == "POST":
            headers.setdefault("Origin", f"http://127.0.0.1:{self.port}")
        headers = {key.replace("_", "-"): value for key, value in headers.items() if value}
        path = name if name.startswith("/") else self.path + name
        connection.request(method, path, body, headers)
        answer = connection.getresponse()
        content = answer.read()
        connection.close()
        return answer.status, content

    def get(self, name):
        status, content = self.request("GET", name)
        assert status == 200, (status, content)
        return json.loads(content)

    def post(self, name, value):
        """Returns the status and the parsed response."""
        status, content = self.request("POST", name, json.dumps(value, ensure_ascii=False).encode())
        return status, json.loads(content or "null")

    def picture(self, topic, frame, size="thumb"):
        status, content = self.request(
            "GET", f"picture?topic={urllib.parse.quote(topic, safe='')}&frame={frame}&size={size}")
        return cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR) \
            if status == 200 else json.loads(content)

    def open_events(self):
        """Returns a stream of events, which stands for an open page until it is closed."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.request("GET", self.path + "events")
        events = connection.getresponse()  # owns the socket from here on
        events.readline()
        return events

    def stop(self):
        """Ends the server as Ctrl-C does; returns the exit status and the output."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        out, err = self.process.communicate(timeout=60)
        return self.process.returncode, out + err


class LabelCase(ToolCase):
    def page(self, *arguments):
        page = Page(self.folder, self.environment(), *arguments)
        self.addCleanup(page.stop)
        return page

    def record(self, name, frames=40, rate=10, start=START, topics=(TOPIC,), labels=()):
        """Writes a bag of `frames` images on each topic; `labels`: (frame, text) pairs."""
        said = dict(labels)
        with rosbag.Bag(str(self.folder / name), "w") as bag:
            for i in range(frames):
                stamp = rospy.Time.from_sec(start + i / rate)
                if i in said:
                    bag.write("/place_label", String(said[i]), stamp)
                for topic in topics:
                    bag.write(topic, jpeg(i), stamp)
        return name

    def stretches(self, bag):
        """Returns the labels of a bag as train reads them."""
        info = self.figures("info", bag)
        return [(label["place"], round(label["from"], 6), round(label["to"], 6))
                for label in info["labels"]]

    def text(self, name):
        return (self.folder / name).read_text()

    def files(self):
        return [name for name in super().files() if not name.startswith("ros_home")]


def span(begin, end, place):
    return {"from": begin, "to": end, "place": place}
