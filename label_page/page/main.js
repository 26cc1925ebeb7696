// The page for labelling a recording: connects its parts and holds the state that they show.

import * as api from "./api.js";
import {Editor} from "./editor.js";
import {clock} from "./format.js";
import {firstFrom, Frames, Thumbnails} from "./frames.js";
import {listKeys, onKeys} from "./keys.js";
import {Overview} from "./overview.js";
import {make, noteOfModel, showDoubts, showRooms, swatch} from "./panel.js";
import {Player} from "./player.js";
import {Review} from "./review.js";
import {Rooms, tidyName} from "./rooms.js";
import {borders, spanAt} from "./spans.js";
import {Timeline} from "./timeline.js";
import {View} from "./view.js";

const element = id => document.getElementById(id);

const recording = await api.getRecording().catch(problem => {
  say(problem.message, true);
  throw problem;
});
const view = new View(recording.duration);
const state = {
  frames: await loadFrames(recording.topic),
  spans: recording.spans,  // as shown, including a border that is being dragged
  rooms: new Rooms(),
  cursor: 0,  // s
  selection: null,  // {from, to}
  answers: [], answerTimes: [], question: 0,
  status: recording.opinion,
  doubts: [], chosen: -1,
};
const editor = new Editor(recording, state, {show: showAll, seek, say});

const thumbnails = new Thumbnails(() => redraw());
const timeline = new Timeline(element("timeline"), state, view, thumbnails,
                              {seek, select, viewChanged: redraw,
                               move: (border, target) => editor.move(border, target),
                               moved: () => editor.endMove(),
                               notMoved: () => editor.cancelMove()});
const overview = new Overview(element("overview"), state, view, redraw);
const review = new Review(state, {change: spans => editor.change(spans), show: showAll,
                                   showStretch});
const player = new Player(element("image"), () => state, seek, element("play"));

async function loadFrames(topic) {
  return new Frames(topic, await api.getTimes(topic), recording.duration);
}

// Display

let drawn = false;

function redraw() {
  if (drawn) return;
  drawn = true;
  requestAnimationFrame(() => {
    drawn = false;
    timeline.draw();
    overview.draw();
  });
}

function placeHere() {
  const at = spanAt(state.spans, state.frames.times[state.frames.at(state.cursor)]);
  return at < 0 ? "" : state.spans[at].place;
}

function showPlace() {
  const number = state.frames.at(state.cursor), place = placeHere();
  element("caption").replaceChildren(
      make("span", {textContent: clock(state.cursor, 2)}), swatch(state.rooms.colour(place)),
      make("span", {className: "room-name", textContent: place || "no room"}),
      make("span", {className: "time",
                    textContent: `frame ${number + 1} of ${state.frames.times.length}`}));
  element("hint").textContent = state.selection
      ? "Press a room's key to label the selected stretch."
      : "Press a room's key to label from here to the next border.";
  showRooms(element("room-list"), state, place,
            {label: name => editor.label(name), rename: name => editor.rename(name)});
}

function showAll() {
  review.update();
  showPlace();
  showModel();
  element("undo").disabled = !editor.history.canUndo;
  element("redo").disabled = !editor.history.canRedo;
  element("save").disabled = editor.isSaved;
  document.title = `${editor.isSaved ? "" : "• "}${element("name").textContent}`;
  redraw();
}

function showModel() {
  const {status} = state;
  element("model").textContent = status.model;
  element("progress").hidden = !status.stage;
  element("progress").value = status.fraction;
  element("model-note").textContent = noteOfModel(status, state);
  element("model-note").classList.toggle("bad", Boolean(status.problem));
  const labelled = new Set(state.spans.map(span => span.place)).size;
  element("learn").disabled = labelled < 2 || Boolean(status.stage);
  element("accept-all").disabled = !state.doubts.some(doubt => doubt.kind === "unlabelled");
  showDoubts(element("doubts"), state, review);
}

function say(text, bad = false) {
  const message = document.getElementById("message");
  message.textContent = text;
  message.classList.toggle("bad", bad);
}

// Navigation

function seek(time) {
  state.cursor = Math.min(Math.max(time, 0), state.frames.times.at(-1));
  player.show();
  showPlace();
  redraw();
}

function goTo(time) {
  seek(time);
  view.reveal(state.cursor);
}

function step(count) {
  const number = state.frames.at(state.cursor) + count;
  goTo(state.frames.times[Math.min(Math.max(number, 0), state.frames.times.length - 1)]);
}

function stepBorder(direction) {
  const number = state.frames.at(state.cursor);
  const {times} = state.frames;
  const starts = [0, ...borders(state.spans)].map(border => firstFrom(times, border))
      .filter(start => start < times.length);
  const next = direction > 0 ? starts.find(start => start > number)
                             : starts.filter(start => start < number).at(-1);
  if (next !== undefined) goTo(times[next]);
}

function select(from, to) {
  state.selection = from < to ? {from, to} : null;
  showPlace();
  redraw();
}

/// Selects a stretch and brings it into view.
function showStretch(from, to) {
  state.selection = {from, to};
  seek(state.frames.times[state.frames.at((from + to) / 2)]);
  view.revealStretch(from, to);
  showModel();
}

function zoom(factor) {
  view.zoom(factor, view.x(state.cursor));
  redraw();
}

// Buttons and keys

const onClick = {
  undo: () => editor.undo(), redo: () => editor.redo(), save: () => editor.save(),
  help: () => element("keys").showModal(),
  split: () => editor.split(), clear: () => editor.label(""), play: () => player.toggle(),
  "zoom-in": () => zoom(1.6), "zoom-out": () => zoom(1 / 1.6), "zoom-all": () => zoom(0),
  learn: () => api.learn(editor.history.spans, state.frames.topic)
    .catch(problem => say(problem.message, true)),
  "accept-all": () => review.acceptRest(),
};
for (const [id, work] of Object.entries(onClick)) {
  element(id).onclick = () => {
    work();
    if (id !== "help") element("timeline").focus();
  };
}

element("new-room").onsubmit = event => {
  event.preventDefault();
  const name = tidyName(element("room-name").value);
  if (editor.complain(name)) return;
  state.rooms.add([name]);
  element("room-name").value = "";
  showPlace();
  element("timeline").focus();
};

element("topic").onchange = async event => {
  state.frames = await loadFrames(event.target.value);
  seek(state.cursor);
  showAll();
  element("timeline").focus();
};

onKeys({
  label: key => { if (state.rooms.ofKey(key)) editor.label(state.rooms.ofKey(key)); },
  clear: () => editor.label(""), split: () => editor.split(), step, stepBorder,
  play: () => player.toggle(),
  second: sign => goTo(state.cursor + sign),
  start: () => goTo(0), end: () => goTo(recording.duration),
  zoom, undo: () => editor.undo(), redo: () => editor.redo(), save: () => editor.save(),
  doubt: count => review.step(count),
  accept: () => review.settle("accept"),
  keep: () => review.settle("keep"),
  deselect: () => select(0, 0), help: () => element("keys").showModal(),
});
listKeys(element("keys").querySelector("table"));

element("name").textContent = recording.bags.map(bag => bag.name).join(", ");
element("topic").replaceChildren(...recording.topics.map(({name, frames}) =>
    new Option(`${name}: ${frames} frames`, name, false, name === recording.topic)));
element("topic").disabled = recording.topics.length < 2;
if (recording.hidden) {
  say(`Not shown: frames more than a day before or after the others (${recording.hidden})`, true);
}
if (recording.unsaved) say("Not saved yet");

addEventListener("resize", redraw);
addEventListener("beforeunload", event => { if (!editor.isSaved) event.preventDefault(); });
api.listen(status => review.hear(status),
           () => say("place_tool has ended. Unsaved changes are lost.", true));

editor.show(recording.spans);
seek(0);
view.width = element("timeline").clientWidth;
view.showAll();
redraw();
element("timeline").focus();
