"""Reads the labels of a recording through place_tool and writes them to RUN.labels.yaml.

On the page, a label is a span {"from", "to", "place"} in page time (recording.py), s. In the file,
times are relative to the bag's start as place_tool reports it.
"""
import bisect
import json
import math
import os
import re
import subprocess
import tempfile
import unicodedata

from recording import LAST_FRAME, Problem

MAX_NAME_BYTES = 128
UNKNOWN = "unknown"
INVISIBLE = set("\u00ad\u200b\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2060\u2061\u2062\u2063\u2064"
                "\u2066\u2067\u2068\u2069\ufeff")
# How subprocess reads place_tool's output: it is UTF-8 in every locale, except for names of files.
TOOL_TEXT = {"encoding": "utf-8", "errors": "replace"}
HEADER = "# Written by `place_tool label`. Seconds since the bag's start, see doc/nodes.md.\n"


def tidy_name(name):
    """Returns `name` as place_tool normalizes it: in NFC, without invisible characters, with each
    run of blanks replaced by one space, and trimmed. Keep in step with tidyName() in page/rooms.js.
    """
    visible = "".join(character for character in name if character not in INVISIBLE)
    composed = unicodedata.normalize("NFC", visible).strip()
    return re.sub(" +", " ", "".join(" " if unicodedata.category(character) == "Zs" else character
                                     for character in composed))


def check_name(name):
    """Raises Problem unless `name` is a valid name of a place."""
    try:
        size = len(name.encode())
    except (AttributeError, UnicodeEncodeError):
        raise Problem("The name of a room must be text.") from None
    if not 0 < size <= MAX_NAME_BYTES:
        raise Problem(f"The name of a room must have 1 to {MAX_NAME_BYTES} bytes; this one has "
                      f"{size}.")
    if any(unicodedata.category(character) == "Cc" for character in name):
        raise Problem("The name of a room must not contain line breaks, tabs or control "
                      "characters.")
    if name.casefold() == UNKNOWN:
        raise Problem(f"'{name}' is reserved for unknown places; choose another name, or leave the "
                      "place unlabelled.")


def require_spans(spans):
    """Raises TypeError, KeyError, ValueError or OverflowError unless `spans` is a list of spans,
    which checked() may still refuse."""
    if not isinstance(spans, list):
        raise TypeError("The spans are not a list.")
    for span in spans:
        if not math.isfinite(span["from"]) or not math.isfinite(span["to"]):
            raise ValueError("A time is not finite.")
        if not isinstance(span["place"], str):
            raise TypeError("A place is not text.")


def checked(spans):
    """Returns the page's `spans` with normalized names. Raises Problem unless they are in order,
    do not overlap and have valid names."""
    end = float("-inf")
    tidy = []
    for span in spans:
        name = tidy_name(span["place"]) if isinstance(span["place"], str) else span["place"]
        check_name(name)
        tidy.append({**span, "place": name})
        if not end <= float(span["from"]) < float(span["to"]) < float("inf"):
            raise Problem("The labels overlap or are out of order; nothing was saved.")
        end = float(span["to"])
    return tidy


def border(time, frames):
    """Returns a time with few decimals that separates the ascending `frames` where `time` does."""
    after = bisect.bisect_left(frames, time)
    if after == 0:
        return 0.0
    low, high = frames[after - 1], frames[after]
    middle = (low + high) / 2
    for digits in range(1, 7):
        rounded = round(middle, digits)
        if low + 1e-7 < rounded < high - 1e-7:
            return rounded
    return middle


def labels_path(bag):
    """Returns the path of the labels file of RUN.bag or RUN.bag.active. Keep in step with
    writtenLabelsFile() in src/ros/bags/bag_file.cpp."""
    if bag.lower().endswith(".bag.active"):
        bag = os.path.splitext(bag)[0]
    return os.path.splitext(bag)[0] + ".labels.yaml"


class BagLabels:
    """The labels of one bag, and the file that holds them."""

    def __init__(self, tool, bag, reading, initial):
        """`tool`: path of place_tool; `reading`: its options that say where labels come from;
        `initial`: the label that an earlier part of the recording carries over, or ""."""
        self.tool = tool
        self.bag = bag
        self.path = labels_path(bag.path)
        self.kept = False  # whether this session has backed up the file that it found
        self.seen = self.bytes_on_disk()
        info = self.ask(*reading, *(["--initial-label=" + initial] if initial else []))
        self.start = info["start"]
        self.present = info["labels"]
        self.frames = [time - self.start for time in bag.all_times()]

    def ask(self, *options):
        """Returns the output of `place_tool info` for the bag."""
        result = subprocess.run([self.tool, "info", "--json", "-", *options, "--", self.bag.path],
                                capture_output=True, **TOOL_TEXT)
        if result.returncode != 0:
            raise Problem(result.stderr.strip().split(": ", 1)[-1] or "place_tool info failed.")
        return json.loads(result.stdout)

    def bytes_on_disk(self):
        try:
            with open(self.path, "rb") as file:
                return file.read()
        except FileNotFoundError:
            return None
        except OSError as error:
            raise Problem(f"Cannot read {self.path}: {error.strerror}; remove it.") from error

    def shift(self):
        """Returns the page time of the bag's start, to which labels are relative."""
        return self.bag.offset - (self.bag.first - self.start)

    def spans(self):
        """Returns the labels read from the bag in page time, clipped to the bag's frames."""
        spans = []
        # Labels may follow the last frame.
        present = [label for label in self.present if label["from"] < self.frames[-1] + 1e-6]
        for label in present:
            # A label that holds to the bag's end is reported to end at the bag's last message.
            ends = label is present[-1] and label["to"] > self.frames[-1] - 1e-6
            span = {"from": max(self.bag.offset, label["from"] + self.shift()),
                    "to": self.bag.end() if ends else label["to"] + self.shift(),
                    "place": label["place"]}
            if span["from"] < span["to"]:
                spans.append(span)
        return spans

    def labels(self, spans):
        """Returns the part of `spans` within this bag, as stored in the file; `to` is None for a
        label that extends to the end. Omits spans that contain no frame."""
        labels = []
        for span in spans:
            begin, end = span["from"] - self.shift(), span["to"] - self.shift()
            first = bisect.bisect_left(self.frames, begin)
            behind = bisect.bisect_left(self.frames, end)
            if first == behind:
                continue
            if behind < len(self.frames):
                end = border(end, self.frames)
            else:
                end = round(self.frames[-1] + LAST_FRAME, 6) if self.bag.goes_on else None
            labels.append({"from": border(begin, self.frames), "to": end, "place": span["place"]})
        return labels

    def save(self, labels):
        """Replaces the file by one with `labels`. Keeps the version from before this session as
        RUN.labels.yaml.old."""
        text = file_text(labels).encode()
        try:
            old = self.bytes_on_disk()
            if old is not None and not self.kept:
                replace_file(self.path + ".old", old)
            self.kept = True
            replace_file(self.path, text, lambda temporary: self.verify(temporary, labels))
        except OSError as error:
            path = error.filename2 or self.path
            raise Problem(f"Cannot write {path}: {error.strerror}; free some disk space, or make "
                          "the file and its folder writable.") from error
        self.seen = text

    def verify(self, path, labels):
        """Raises Problem unless place_tool reads `labels` back from `path`."""
        info = self.ask("--labels", path)
        read = [[label["place"], label["from"], label["to"]] for label in info["labels"]]
        meant = []
        for label in labels:
            end = info["duration"] if label["to"] is None else min(label["to"], info["duration"])
            # place_tool merges adjacent labels of the same place.
            if meant and meant[-1][0] == label["place"] and meant[-1][2] == label["from"]:
                meant[-1][2] = end
            else:
                meant.append([label["place"], label["from"], end])
        same = len(read) == len(meant) and all(
            a[0] == b[0] and abs(a[1] - b[1]) < 1e-6 and abs(a[2] - b[2]) < 1e-6
            for a, b in zip(read, meant))
        if not same:
            raise Problem("place_tool would read other labels from the file; nothing was saved.")


def file_text(labels):
    """Returns the text of RUN.labels.yaml. Names are JSON strings, which are valid YAML."""
    text = HEADER + "times: relative\nlabels:" + ("" if labels else " []") + "\n"
    for label in labels:
        end = "" if label["to"] is None else f"to: {label['to']!r}, "
        place = json.dumps(label["place"], ensure_ascii=False)
        text += f"  - {{from: {label['from']!r}, {end}place: {place}}}\n"
    return text


def replace_file(path, data, check=lambda temporary: None):
    """Replaces a file atomically: at any moment, `path` is either the old file or the complete new
    one. Calls `check` with the name of the new file first; if that raises, the old file stays."""
    folder, name = os.path.split(os.path.abspath(path))
    descriptor, temporary = tempfile.mkstemp(os.path.splitext(name)[1], f".{name}.", folder)
    try:
        mask = os.umask(0)
        os.umask(mask)
        os.fchmod(descriptor, 0o666 & ~mask)
        with os.fdopen(descriptor, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        check(temporary)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
    descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


class RecordingLabels:
    """The labels of all bags of a recording."""

    def __init__(self, tool, recording, reading, initial):
        """`initial`: by path of a bag, the label that it continues with; see BagLabels."""
        self.bags = [BagLabels(tool, bag, reading, initial.get(bag.path, ""))
                     for bag in recording.bags]

    def spans(self):
        """Returns the labels of all bags; a label that continues in the next bag is one span."""
        spans = []
        for bag in self.bags:
            for span in bag.spans():
                before = spans[-1] if spans else None
                if before and before["place"] == span["place"] \
                        and span["from"] == before["to"]:
                    before["to"] = span["to"]
                else:
                    spans.append(span)
        return spans

    def save(self, spans, overwrite):
        """Writes the file of each bag and returns the paths. Raises Problem; raises Changed if a
        file has changed since it was read, unless `overwrite`."""
        spans = checked(spans)
        changed = [bag.path for bag in self.bags if bag.bytes_on_disk() != bag.seen]
        if changed and not overwrite:
            verb = "has" if len(changed) == 1 else "have"
            raise Changed(f"{', '.join(changed)} {verb} changed since this page read the labels.")
        for bag in self.bags:
            bag.save(bag.labels(spans))
        return [bag.path for bag in self.bags]


class Changed(Problem):
    """A labels file has changed since it was read."""
