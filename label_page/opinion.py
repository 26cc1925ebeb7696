"""Collects a model's answers to the recording.

A place_tool child process recognizes the frames, with a given model or with one that another child
first trains on the page's labels. Answers are collected as they arrive.
"""
import json
import os
import subprocess
import tempfile
import threading

from labels_file import TOOL_TEXT, file_text

# The page is not sent probabilities below this.
LEAST = 0.005


class Opinion:
    """One model's answers to the frames of one topic, in order. Thread-safe."""

    def __init__(self, tool, recording, topic, on_change):
        self.tool = tool
        self.recording = recording
        self.topic = topic
        self.on_change = on_change
        self.lock = threading.Lock()
        self.child = None
        self.number = 0  # of the current question; answers to older questions are dropped
        self.answers = []  # [page time, place or "", {place: probability}, probability of unknown]
        self.state = {"model": "", "stage": "", "fraction": 0, "problem": ""}

    def status(self):
        with self.lock:
            return dict(self.state, question=self.number, answers=len(self.answers),
                        frames=len(self.recording.times[self.topic]))

    def since(self, question, count):
        """Returns the answers to `question`, without the first `count`."""
        with self.lock:
            return self.answers[count:] if question == self.number else []

    def ask(self, model):
        """Discards all answers and starts recognizing every frame with `model`."""
        self.start(lambda number: self.recognize(number, model), model)

    def learn(self, labels, topic):
        """Trains a model on `labels`, one list per bag (BagLabels.labels()), and the images of
        `topic`, and then asks it."""
        self.start(lambda number: self.learn_and_ask(number, labels), "these labels", topic)

    def start(self, work, model, topic=None):
        with self.lock:
            self.topic = topic or self.topic
            self.number += 1
            number = self.number
            self.stop_child()
            self.answers = []
            self.state = {"model": model, "stage": "Starting", "fraction": 0, "problem": ""}
        self.on_change()
        threading.Thread(target=work, args=(number,), daemon=True).start()

    def stop(self):
        with self.lock:
            self.number += 1
            self.stop_child()

    def stop_child(self):
        if self.child and self.child.poll() is None:
            self.child.kill()

    def learn_and_ask(self, number, labels):
        with tempfile.TemporaryDirectory(prefix="place_tool_label_") as folder:
            # place_tool finds labels beside a bag; links keep the user's folder untouched.
            bags = []
            for i, (bag, of_bag) in enumerate(zip(self.recording.bags, labels)):
                if not of_bag or self.topic not in bag.entries:
                    continue
                bags.append(os.path.join(folder, f"{i}.bag"))
                os.symlink(os.path.abspath(bag.path), bags[-1])
                with open(os.path.join(folder, f"{i}.labels.yaml"), "wb") as file:
                    file.write(file_text(of_bag).encode())
            if not bags:
                self.tell(number, stage="", problem="place_tool train: no labelled bag has images on "
                                                    f"{self.topic}; show another topic.")
                return
            model = os.path.join(folder, "labels.places")
            command = ["train", *bags, "--image-topic", self.topic, "--model", model,
                       "--set", "sampling.rate=5", "--progress", "json"]
            if self.run(number, command, self.on_progress):
                self.recognize(number, model)

    def recognize(self, number, model):
        self.tell(number, stage="Recognizing", fraction=0)
        bags = [bag for bag in self.recording.bags if self.topic in bag.entries]
        shown = iter(self.recording.times[self.topic])
        times = iter([next(shown) if is_shown else None
                      for bag in bags for is_shown in bag.frames[self.topic]])
        command = ["recognize", "--image-topic", self.topic, "--model", model, "--json", "-",
                   "--progress", "none", "--", *(bag.path for bag in bags)]
        done = self.run(number, command, lambda n, line: self.on_answer(n, line, times))
        if done:
            self.tell(number, stage="", fraction=1)

    def on_progress(self, number, line):
        progress = json.loads(line)
        if "stage" in progress:
            self.tell(number, stage=progress["stage"], fraction=progress["fraction"])

    def on_answer(self, number, line, times):
        answer = json.loads(line)
        time = next(times)
        if time is None:
            return
        over_time = answer.get("smoothed") or {
            "place": answer["place"], "known": answer["known"], "evidence": 1,
            "probabilities": {place: score["probability"]
                              for place, score in answer["scores"].items()}}
        evidence = over_time["evidence"]
        probabilities = {place: round(p * evidence, 3)
                         for place, p in over_time["probabilities"].items()
                         if p * evidence >= LEAST}
        place = over_time["place"] if over_time["known"] else ""
        with self.lock:
            if number != self.number:
                return
            self.answers.append([round(time, 6), place, probabilities,
                                 round(1 - evidence, 3)])
            self.state["fraction"] = len(self.answers) / len(self.recording.times[self.topic])
        self.on_change()

    def tell(self, number, **changes):
        with self.lock:
            if number == self.number:
                self.state.update(changes)
        self.on_change()

    def run(self, number, arguments, on_line):
        """Runs place_tool and passes each line of its output to on_line(number, line). Returns
        whether it succeeded; reports a failure in the status."""
        with self.lock:
            if number != self.number:
                return False
            child = subprocess.Popen([self.tool, *arguments], stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                                     **TOOL_TEXT)
            self.child = child
        errors = []
        reader = threading.Thread(target=lambda: errors.extend(child.stderr), daemon=True)
        reader.start()
        for line in child.stdout:
            on_line(number, line)
        reader.join()
        if child.wait() == 0:
            return True
        last = errors[-1].strip() if errors else f"place_tool {arguments[0]} ended unexpectedly."
        self.tell(number, stage="", problem=last)
        return False
