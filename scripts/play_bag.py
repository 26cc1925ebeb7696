#!/usr/bin/env python3
"""Runs rosbag play for replay.launch, which passes its arguments as environment variables.

BAG is an absolute path, a path that starts with ~/ or $HOME/, or a path relative to the folder in
which roslaunch was called; it may contain blanks and quotes. A list in brackets names the parts of
a split recording. IMAGE and ODOMETRY are topics, with or without a leading slash. TRANSPORT
is the form in which the recognizer takes the images, raw or compressed. RATE is the
playback speed relative to the recording, LOOP whether to start again at the end. Playback starts
once the image topic has a subscriber; rosbag's --wait-for-subscribers would also wait for a
subscriber to the labels.
"""
import os
import re
import signal
import sys
import time

import rosbag
import rosgraph
import roslib.packages
import yaml

YES = ("true", "yes", "on", "1")
NO = ("false", "no", "off", "0")
CONNECTING = "1"  # time for a subscriber to connect to the player, s
PATIENCE = 5  # time without a subscriber after which to say so, s


def bag_path(bag):
    folder_of_call = os.readlink(f"/proc/{os.getppid()}/cwd")
    path = os.path.join(folder_of_call, os.path.expandvars(os.path.expanduser(bag)))
    if os.path.isdir(path):
        sys.exit(f"{path} is a folder; give a bag in it as bag:=PATH.")
    if not os.path.isfile(path):
        sys.exit(f"There is no file {path}; {bag_beside(path) or 'give the path of a bag as bag:=PATH'}.")
    return path


def bag_beside(path):
    """Returns what to do about the bag that is probably meant by a path at which there is none."""
    bag = path if path.endswith(".bag") else path + ".bag"
    if os.path.isfile(bag):
        return f"give {bag}, which lies beside it"
    active = bag + ".active"
    return os.path.isfile(active) and (
        f"{active} lies beside it: it is being recorded, or was left behind by a killed recorder; in the "
        f"latter case run: rosbag reindex {active}, and rename it to {bag} ({bag}.orig.active is its backup)")


def bag_paths(given):
    """Returns the paths of the bags that `given`, a path or a list in brackets, names."""
    if not given.startswith("["):
        return [bag_path(given)]
    try:
        bags = yaml.load(given, yaml.BaseLoader)
    except yaml.YAMLError:
        bags = None
    if not bags or not all(isinstance(bag, str) for bag in bags):
        sys.exit(f"The argument bag is '{given}'; give a path, or a list as in bag:='[run_0.bag, run_1.bag]'.")
    return [bag_path(bag) for bag in bags]


def pace(rate):
    try:
        if 0 < float(rate) < float("inf"):
            return rate
    except ValueError:
        pass
    sys.exit(f"The argument rate is '{rate}'; give a number above 0, as in rate:=2.")


def is_loop(loop):
    if loop.lower() not in YES + NO:
        sys.exit(f"The argument loop is '{loop}'; give true or false.")
    return loop.lower() in YES


def recorded_topics(path):
    """Returns the bag's topics and their message types."""
    try:
        with rosbag.Bag(path) as bag:
            return {name: topic.msg_type for name, topic in bag.get_type_and_topic_info().topics.items()}
    except rosbag.ROSBagUnindexedException:
        sys.exit(f"{path} has no index because its recording was interrupted; run: rosbag reindex {path}")
    except (rosbag.ROSBagException, OSError, ValueError) as e:
        sys.exit(f"Cannot read {path}: {e}; copy or record it again.")


def meant(names, recorded):
    """Returns the recorded topics with these names, ignoring leading slashes."""
    bare = {name.lstrip("/") for name in names}
    return [topic for topic in recorded if topic.lstrip("/") in bare]


def image_topics(image, transport, recorded, bags):
    """Returns the recorded topics of the images of a camera in the form that is listened to."""
    kinds = {"raw": ("", "sensor_msgs/Image"), "compressed": ("/compressed", "sensor_msgs/CompressedImage")}
    forms = {form: [topic for topic in meant([image + ending], recorded) if recorded[topic] == kind]
             for form, (ending, kind) in kinds.items()}
    base = re.sub("/compressed$", "", image)
    if base != image and not any(forms.values()) and meant([image], recorded):
        sys.exit(f"{image} is the topic of compressed images; give the topic without /compressed: image:={base}.")
    if not any(forms.values()):
        there = ", ".join(name for name, kind in sorted(recorded.items()) if "Image" in kind)
        sys.exit(f"{bags} has no images on {image}; image topics: {there or 'none'}.")
    for form, other in (("raw", "compressed"), ("compressed", "raw")):
        if transport == form and not forms[form]:
            sys.exit(f"{bags} has {other} images on {image}; add image_transport:={other}.")
    return forms["raw"] + forms["compressed"]


def odometry_topics(odometry, recorded, bags):
    """Returns the recorded topic of the odometry; none if it is not used."""
    topics = [topic for topic, kind in recorded.items() if kind == "nav_msgs/Odometry"]
    used = meant([odometry], topics)
    if odometry != "none" and not used:
        sys.exit(f"{bags} has no odometry (nav_msgs/Odometry) on {odometry}; odometry topics: "
                 f"{', '.join(sorted(topics)) or 'none'}. Give one of them, or leave out odometry.")
    return used


def wait_for_listener(topics):
    """Waits until the master lists a subscriber to one of the topics."""
    master = rosgraph.Master("/play")
    wanted = {"/" + topic.lstrip("/") for topic in topics}
    warning = time.time() + PATIENCE
    while not wanted & {topic for topic, _ in master.getSystemState()[1]}:
        time.sleep(0.1)
        if time.time() > warning:
            warning = float("inf")
            print(f"Waiting for a subscriber to {' or '.join(sorted(wanted))}, the topic of the "
                  "bag's images; see image_transport.", flush=True)


def main():
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    paths = bag_paths(os.environ["BAG"])
    options = ["--rate", pace(os.environ["RATE"]), "--delay", CONNECTING]
    if is_loop(os.environ["LOOP"]):
        options.append("--loop")
    transport = os.environ["TRANSPORT"]
    if transport not in ("raw", "compressed"):
        sys.exit(f"The argument image_transport is '{transport}'; give raw or compressed.")
    recorded = {name: kind for path in paths for name, kind in recorded_topics(path).items()}
    image = os.environ["IMAGE"]
    bags = " ".join(paths)
    images = image_topics(image, transport, recorded, bags)
    others = meant(["/place_label", "/tf", "/tf_static"], recorded)
    others += odometry_topics(os.environ["ODOMETRY"], recorded, bags)
    wait_for_listener(images)
    print(f"Playing {', '.join(paths)}.", flush=True)
    player = roslib.packages.find_node("rosbag", "play")[0]
    os.execv(player, [player, *options, *sys.argv[1:], "--topics", *images, *others, "--bags", *paths])


if __name__ == "__main__":
    main()
