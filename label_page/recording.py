"""The recording that `place_tool label` shows: the frames of one or more bags, laid end to end on
one time axis, and their images.

Bags are ordered by their first frame. The page time of a frame is the bag's offset plus the seconds
since the bag's first frame, so neither pauses between bags nor overlaps matter.
"""
import os
import tempfile
import threading

# Largest side of an image that the package accepts, pixels. OpenCV reads the environment variable
# when it is imported.
MAX_SIDE = 8192
os.environ.setdefault("OPENCV_IO_MAX_IMAGE_PIXELS", str(MAX_SIDE * MAX_SIDE))

import cv2  # noqa: E402
import numpy as np  # noqa: E402
import rosbag  # noqa: E402
from cv_bridge import CvBridge  # noqa: E402
from sensor_msgs.msg import CompressedImage, Image  # noqa: E402

# rosbag generates Python code from the message definitions in a bag unless it knows the type. With
# these two registered it never does so, because no other messages are read.
IMAGE_TYPES = {message._type: message for message in (Image, CompressedImage)}
rosbag.bag._message_types.update({message._md5sum: message for message in IMAGE_TYPES.values()})

# Maximum heights of the images that the page requests, pixels, and their JPEG quality.
HEIGHTS = {"thumb": 96, "view": 600}
QUALITY = {"thumb": 80, "view": 88}

# Encodings, beside those that every release of cv_bridge knows: YUYV, and other names of a layout.
# Keep in step with src/ros/messages, which decodes the images that are learned.
YUY2 = "yuv422_yuy2"
SAME_PIXELS = {"8UC1": "mono8", "8UC3": "bgr8", "16UC1": "mono16"}
BAYER = ("bayer_rggb", "bayer_bggr", "bayer_gbrg", "bayer_grbg")

# Duration of a bag's last frame in page time, s.
LAST_FRAME = 0.01


class Problem(Exception):
    """An error whose message is a sentence for the user of the page."""


def largest_group(times):
    """Returns the first and last of the largest group of the ascending `times`. A gap of more than
    a day, caused by a clock that was not set, separates groups, as in place_tool."""
    day = 24 * 60 * 60
    starts = [0, *(i for i in range(1, len(times)) if times[i] - times[i - 1] > day), len(times)]
    _, first, end = max((end - start, start, end) for start, end in zip(starts, starts[1:]))
    return times[first], times[end - 1]


class Bag:
    """The frames of one bag, by topic. Reading is thread-safe."""

    def __init__(self, path):
        self.path = path
        self.lock = threading.Lock()
        self.bag = rosbag.Bag(path)
        self.entries = {}  # topic -> index entries in order of time
        for topic in self.image_topics():
            entries = self.bag._get_entries(list(self.bag._get_connections([topic])))
            self.entries[topic] = list(entries)
        times = self.all_times()
        self.first, self.last = largest_group(times)
        self.goes_on = times[-1] > self.last  # with frames that are not shown
        self.frames = {}  # topic -> whether each of its frames is shown
        for topic, entries in self.entries.items():
            self.frames[topic] = [self.first <= entry.time.to_sec() <= self.last
                                  for entry in entries]
            self.entries[topic] = [entry for entry, shown in zip(entries, self.frames[topic])
                                   if shown]
        self.hidden = len(times) - len(self.all_times())
        self.offset = 0.0

    def image_topics(self):
        topics = {connection.topic for connection in self.bag._get_connections()
                  if IMAGE_TYPES.get(connection.datatype)
                  and IMAGE_TYPES[connection.datatype]._md5sum == connection.md5sum}
        topics = {topic for topic in topics if not topic.endswith("/compressedDepth")
                  and self.bag.get_message_count(topic) > 0}
        if not topics:
            raise Problem(f"{self.path} contains no images; check it with place_tool info.")
        return topics

    def end(self):
        """Returns the bag's end in page time."""
        return self.offset + self.last - self.first + LAST_FRAME

    def page_times(self, topic):
        return [self.offset + entry.time.to_sec() - self.first
                for entry in self.entries.get(topic, ())]

    def all_times(self):
        """Returns the times of all frames, absolute, s, ascending."""
        return sorted(entry.time.to_sec() for entries in self.entries.values()
                      for entry in entries)

    def message(self, topic, number):
        with self.lock:
            return self.bag._read_message(self.entries[topic][number].position).message


class Recording:
    """One or more bags as one recording, in order of time."""

    def __init__(self, paths):
        self.bags = sorted((Bag(path) for path in paths), key=lambda bag: bag.first)
        for before, bag in zip(self.bags, self.bags[1:]):
            bag.offset = before.end()
        self.duration = self.bags[-1].end()
        self.times = {topic: [time for bag in self.bags for time in bag.page_times(topic)]
                      for topic in sorted({topic for bag in self.bags for topic in bag.entries})}
        self.images = ImageStore()

    def topic(self, wanted):
        """Returns the image topic named `wanted`, with or without "/compressed"; the first topic if
        `wanted` is empty. Raises Problem if there is none."""
        if not wanted:
            return next(iter(self.times))
        for topic in (wanted, wanted + "/compressed"):
            if topic in self.times:
                return topic
        raise Problem(f"There are no images on {wanted}; the image topics are "
                      f"{', '.join(self.times)}.")

    def locate(self, topic, number):
        """Returns the bag that holds frame `number` of a topic, and the frame's number in it."""
        for bag in self.bags:
            count = len(bag.entries.get(topic, ()))
            if number < count:
                return bag, number
            number -= count
        raise IndexError(number)

    def image(self, topic, number, size):
        """Returns frame `number` of a topic as JPEG. Raises Problem if it cannot be decoded."""
        return self.images.get((topic, number, size), lambda: self._make(topic, number, size))

    def _make(self, topic, number, size):
        bag, there = self.locate(topic, number)
        image = decode(bag.message(topic, there), HEIGHTS[size])
        height = min(HEIGHTS[size], image.shape[0])
        width = max(1, round(image.shape[1] * height / image.shape[0]))
        if height < image.shape[0]:
            image = cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA)
        quality = [cv2.IMWRITE_JPEG_QUALITY, QUALITY[size]]
        return cv2.imencode(".jpg", image, quality)[1].tobytes()


class ImageStore:
    """Caches JPEG images for the session in an unnamed temporary file. Thread-safe."""

    def __init__(self):
        self.file = tempfile.TemporaryFile(prefix="place_tool_label_")
        self.extents = {}  # key -> (offset, length)
        self.end = 0
        self.lock = threading.Lock()

    def get(self, key, make):
        """Returns the image stored under `key`; calls `make` and stores the result if there is
        none."""
        with self.lock:
            extent = self.extents.get(key)
        if extent:
            return os.pread(self.file.fileno(), extent[1], extent[0])
        image = make()
        with self.lock:
            os.pwrite(self.file.fileno(), image, self.end)
            self.extents[key] = (self.end, len(image))
            self.end += len(image)
        return image


def decode(message, height):
    """Returns the image of a message, 8-bit BGR. An image with more than `height` rows may be
    decoded at reduced size, but not below `height` rows. Raises Problem."""
    try:
        image = decode_compressed(message, height) if hasattr(message, "format") \
            else decode_raw(message)
    except Exception as error:  # anything that numpy, OpenCV and cv_bridge raise on damaged data
        raise Problem(f"This frame cannot be decoded: {error}") from error
    if image is None or image.size == 0:
        raise Problem("This frame cannot be decoded.")
    return image


def decode_compressed(message, height):
    data = message.data
    is_webp = data.startswith(b"RIFF") and data[8:12] == b"WEBP"
    if not is_webp and not data.startswith((b"\xff\xd8\xff", b"\x89PNG\r\n\x1a\n")):
        raise Problem("it is not a JPEG, PNG or WebP image.")
    bayer, is_rgb = pixels_of(message.format)
    # JPEG decodes much faster at half, a quarter or an eighth of its size.
    rows = 0 if bayer else jpeg_rows(data)
    for divisor, flag in ((8, cv2.IMREAD_REDUCED_GRAYSCALE_8), (4, cv2.IMREAD_REDUCED_GRAYSCALE_4),
                          (2, cv2.IMREAD_REDUCED_GRAYSCALE_2)):
        if rows >= divisor * height:
            break
    else:
        flag = cv2.IMREAD_GRAYSCALE
    flag |= cv2.IMREAD_ANYCOLOR | cv2.IMREAD_ANYDEPTH
    image = in_eight_bits(cv2.imdecode(np.frombuffer(data, np.uint8), flag))
    if image is None:
        return None
    encoding = (bayer or "mono8") if image.ndim == 2 else "rgb8" if is_rgb else "bgr8"
    return in_bgr(CvBridge().cv2_to_imgmsg(image, encoding))


def pixels_of(image_format):
    """Returns the Bayer encoding, or "", of a compressed image that is grey, and whether one in
    colour is RGB, as encodingOf() in src/ros/messages/compressed_conversions.cpp."""
    before, semicolon, stored = image_format.lstrip(" ").lower().partition(";")
    bayer = before[:10] + "8" if semicolon and before.startswith(BAYER) else ""
    has_colour = semicolon and before.startswith(("rgb", "bgr"))
    return bayer, bool(has_colour) and "compressed bgr" not in stored


def in_bgr(message):
    return CvBridge().imgmsg_to_cv2(message, "bgr8")


def in_eight_bits(image):
    """Returns a 16-bit image in 8 bits: the most significant of the bits that 99.5 % of its pixels
    use. Returns any other image unchanged."""
    if image is None or image.dtype != np.uint16:
        return image
    bits = max(8, int(np.percentile(image, 99.5)).bit_length())
    return np.minimum(image >> (bits - 8), 255).astype(np.uint8)


def jpeg_rows(data):
    """Returns the height stated in the header of a JPEG image; 0 if there is none."""
    at = 2
    while at + 9 < len(data) and data[at] == 0xff:
        marker = data[at + 1]
        if 0xc0 <= marker <= 0xcf and marker not in (0xc4, 0xc8, 0xcc):
            return int.from_bytes(data[at + 5:at + 7], "big")
        at += 2 + int.from_bytes(data[at + 2:at + 4], "big")
    return 0


def decode_raw(message):
    if not (0 < message.width <= MAX_SIDE and 0 < message.height <= MAX_SIDE):
        raise Problem(f"it claims {message.width} x {message.height} pixels.")
    message.encoding = SAME_PIXELS.get(message.encoding, message.encoding)
    dtype, channels = ("uint8", 2) if message.encoding == YUY2 \
        else CvBridge().encoding_to_dtype_with_channels(message.encoding)
    if channels == 2 and message.width % 2:  # OpenCV would write behind the end of the image
        raise Problem("it has an odd width, although two pixels share their colour.")
    row = message.width * channels * np.dtype(dtype).itemsize
    if message.step < row or len(message.data) < message.step * (message.height - 1) + row:
        raise Problem("it has fewer bytes than it claims.")
    if message.step != row:  # cv_bridge for Python assumes rows without padding
        data = np.frombuffer(message.data, np.uint8)
        data = np.lib.stride_tricks.as_strided(data, (message.height, row), (message.step, 1))
        message.data, message.step = data.tobytes(), row
    if message.encoding == YUY2:
        image = np.ndarray((message.height, message.width, 2), np.uint8, message.data)
        return cv2.cvtColor(image, cv2.COLOR_YUV2BGR_YUY2)
    if dtype == "uint16":
        image = in_eight_bits(CvBridge().imgmsg_to_cv2(message))
        message = CvBridge().cv2_to_imgmsg(image, message.encoding.replace("16", "8"))
    return in_bgr(message)
