// The lists beside the image: the rooms and their keys, and the stretches that the model questions.

import {clock, length} from "./format.js";

const kMostDoubts = 200;
const kKinds = {contradicts: "contradicted", doubts: "doubted", unlabelled: "not labelled"};

/// Creates an element with properties and children.
export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

export function swatch(colour) {
  const element = make("span", {className: "swatch"});
  element.style.background = colour;
  return element;
}

/// Fills the list of rooms. `here`: the room at the cursor; `on`: label(name), rename(name).
export function showRooms(list, state, here, on) {
  const seconds = new Map();
  for (const {from, to, place} of state.spans) {
    seconds.set(place, (seconds.get(place) ?? 0) + to - from);
  }
  const time = name => seconds.has(name) ? length(seconds.get(name)) : "";
  list.replaceChildren(...[...state.rooms.names, ""].map(name => {
    const key = name ? state.rooms.key(name) : "0";
    const room = make("button", {className: "room"}, swatch(state.rooms.colour(name)),
                      make("span", {className: "room-name", textContent: name || "no room"}),
                      make("span", {className: "time", textContent: time(name)}));
    if (key) room.append(make("kbd", {textContent: key}));
    room.classList.toggle("here", name === here);
    room.onclick = () => on.label(name);
    const rename = make("button", {className: "rename", textContent: "✎", title: "Rename"});
    rename.onclick = () => on.rename(name);
    return make("li", {}, room, ...name ? [rename] : []);
  }));
}

/// Returns "kitchen → corridor", or the label alone if the model names the same room without being
/// sure.
function whatOf(doubt, rooms) {
  const what = make("div", {className: "what"},
                    swatch(rooms.colour(doubt.label)), ` ${doubt.label || "no label"}`);
  if (doubt.place !== doubt.label) {
    what.append(" → ", swatch(rooms.colour(doubt.place)), ` ${doubt.place || "unknown"}`);
  }
  return what;
}

function whyOf(doubt) {
  const sure = doubt.kind === "doubts" ? `, ${Math.round(100 * (1 - doubt.fraction))} % sure` : "";
  return make("div", {className: "why", textContent:
      `${clock(doubt.from, 0)} · ${length(doubt.to - doubt.from)} · ${kKinds[doubt.kind]}${sure}`});
}

/// Fills the list of stretches that the model questions. `review`: a Review.
export function showDoubts(list, state, review) {
  const tell = (doubt, i) => {
    const accept = make("button", {textContent: "Accept", title: "Use the model's answer (Enter)"});
    const keep = make("button", {textContent: "Keep", title: "Keep the label (Backspace)"});
    keep.hidden = doubt.kind === "unlabelled";
    accept.hidden = doubt.place === doubt.label;
    const item = make("li", {}, make("div", {}, whatOf(doubt, state.rooms), whyOf(doubt)), keep,
                      accept);
    item.classList.toggle("chosen", i === state.chosen);
    item.onclick = () => review.choose(i);
    accept.onclick = event => { event.stopPropagation(); review.accept(doubt); };
    keep.onclick = event => { event.stopPropagation(); review.keep(doubt); };
    return item;
  };
  list.replaceChildren(...state.doubts.slice(0, kMostDoubts).map(tell));
  list.querySelector(".chosen")?.scrollIntoView({block: "nearest"});
}

/// Returns the note below the model's name.
export function noteOfModel(status, state) {
  if (status.problem) return status.problem;
  if (status.stage) return `${status.stage} …`;
  if (!status.model) {
    return "No model yet. Label a short stretch of each room, then choose “Learn from labels”.";
  }
  const counts = Object.entries(kKinds).map(([kind, what]) =>
      [state.doubts.filter(doubt => doubt.kind === kind).length, what]).filter(([count]) => count);
  if (!counts.length) return "The model agrees with all labels.";
  return `Stretches: ${counts.map(([count, what]) => `${count} ${what}`).join(", ")}`;
}
