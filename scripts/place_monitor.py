#!/usr/bin/env python3
"""Prints the room over time of place_recognizer: one line whenever it or the true label changes.

  rosrun place_recognition place_monitor.py [--recognizer /place_recognizer] [--label-topic /place_label]

A line has the room of ~place with its probability (~belief). If the label topic is published, as
when a labelled bag is replayed, the true label is printed beside it. Ends with a summary on Ctrl-C
or after --idle-exit seconds without an answer.
"""
import argparse
import sys
import threading
import time

import rospy
from place_recognition.msg import PlaceRecognition
from std_msgs.msg import String


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def answer_of(message):
    return message.place if message.known else "unknown"


PATIENCE = 5  # time without a publisher after which to say so, s


class Count:
    """The fraction of right answers among the labelled frames."""

    def __init__(self):
        self.right = self.labelled = 0

    def add(self, answer, truth):
        if truth:
            self.labelled += 1
            self.right += answer == truth

    def __str__(self):
        return f"{100 * self.right / max(self.labelled, 1):.1f} %"


class Monitor:
    def __init__(self, recognizer, label_topic):
        self.lock = threading.Lock()
        self.truth = ""
        self.shown = None  # (answer, truth) of the last line printed
        self.lost = None  # wall time at which ~place became unknown; None: it names a room
        self.start = time.time()
        self.first = self.last = None  # wall time of the first and last answer
        self.last_belief = 0  # wall time of the last room over time that comes from an image
        self.first_stamp = None  # s
        self.seconds = []
        self.single, self.over_time = Count(), Count()
        rospy.Subscriber(label_topic, String, self.on_label, queue_size=10)
        rospy.Subscriber(recognizer + "/recognition", PlaceRecognition, self.on_answer,
                         queue_size=1000)
        self.beliefs = rospy.Subscriber(recognizer + "/belief", PlaceRecognition, self.on_belief,
                                        queue_size=1000)
        self.is_heard = False  # whether somebody has published the room over time, or this was said
        rospy.Subscriber(recognizer + "/place", String, self.on_place, queue_size=10)

    def on_label(self, message):
        with self.lock:
            self.truth = message.data

    def on_answer(self, message):
        with self.lock:
            self.last = time.time()
            self.first = self.first or self.last
            self.seconds.append(message.seconds)
            self.single.add(answer_of(message), self.truth)

    def on_belief(self, message):
        with self.lock:
            self.last_belief = time.time()
            answer = answer_of(message)
            self.over_time.add(answer, self.truth)
            if (answer, self.truth) != self.shown:
                self.shown = (answer, self.truth)
                self.print_line(message, answer)

    def on_place(self, message):
        with self.lock:
            self.lost = time.time() if message.data == "unknown" else None

    def look_for_silence(self):
        """Prints that the place is unknown when this comes from no image: the camera is silent or
        shows nothing, or the recognizer has been disabled."""
        with self.lock:
            silent = self.lost and time.time() - max(self.lost, self.last_belief) > 0.5
            if silent and self.shown and self.shown[0] != "unknown":
                self.shown = ("unknown", self.truth)
                print("       - s   unknown", flush=True)

    def look_for_publisher(self):
        """Prints once that nobody publishes the room over time."""
        self.is_heard = self.is_heard or self.beliefs.get_num_connections() > 0
        if not self.is_heard and time.time() - self.start > PATIENCE:
            self.is_heard = True
            print(f"Nobody publishes {self.beliefs.resolved_name}; start place_recognizer, or name it "
                  "with --recognizer.", flush=True)

    def print_line(self, message, answer):
        verdict = ""
        if self.truth:
            mark = "right" if answer == self.truth else "wrong" if message.known else "  -  "
            verdict = f"   {mark}   truth: {self.truth}"
        probability = (message.confidence * message.evidence if message.known
                       else 1 - message.evidence)
        stamp = message.header.stamp.to_sec()
        self.first_stamp = self.first_stamp or stamp
        print(f"{stamp - self.first_stamp:8.2f} s   {answer:<16}"
              f" {100 * probability:3.0f} %{verdict}", flush=True)

    def is_idle(self, seconds):
        """Returns whether there has been no answer for `seconds`; allows ten times as long for the
        first answer."""
        with self.lock:
            now = time.time()
            return now - self.last > seconds if self.last else now - self.start > 10 * seconds

    def summary(self):
        if len(self.seconds) < 2:
            return "fewer than two frames were answered"
        rate = (len(self.seconds) - 1) / max(self.last - self.first, 1e-9)
        text = (f"{len(self.seconds)} frames answered, {rate:.0f} per second; latency in the node "
                f"{1e3 * percentile(self.seconds, 0.5):.1f} ms (median), "
                f"{1e3 * percentile(self.seconds, 0.99):.1f} ms (99th percentile)")
        if self.single.labelled:
            text += (f"; of the labelled frames {self.single} are right frame by frame, "
                     f"{self.over_time} over time")
        return text


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--recognizer", default="/place_recognizer", help="name of the node")
    parser.add_argument("--label-topic", default="/place_label", help="topic of the true labels")
    parser.add_argument("--idle-exit", type=float, default=0, metavar="S",
                        help="end after this many seconds without an answer, or ten times as many "
                             "before the first one; 0: never")
    options = parser.parse_args(rospy.myargv(sys.argv)[1:])
    rospy.init_node("place_monitor", anonymous=True)
    for name in rospy.get_param("~", {}):
        rospy.logwarn("The parameter ~%s has no effect here; give an option, see --help.", name)
    monitor = Monitor(options.recognizer, options.label_topic)
    while not rospy.is_shutdown():
        time.sleep(0.1)
        monitor.look_for_silence()
        monitor.look_for_publisher()
        if options.idle_exit and monitor.is_idle(options.idle_exit):
            break
    print(monitor.summary(), flush=True)


if __name__ == "__main__":
    main()
