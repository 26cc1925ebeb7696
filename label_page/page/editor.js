// Changes of the labels by the user: their history, the draft that the server keeps, and saving.

import * as api from "./api.js";
import {faultOfName, tidyName, twinOf} from "./rooms.js";
import {endOfStretch, History, moveBorder, paint, split} from "./spans.js";

export class Editor {
  /// `page`: show(), seek(time), say(text, bad).
  constructor(recording, state, page) {
    Object.assign(this, {recording, state, page});
    this.history = new History(recording.spans);
    this.saved = recording.unsaved ? null : this.history.spans;
    this.moving = null;  // original time of the border that is being dragged, s
  }

  get isSaved() { return this.history.spans === this.saved; }

  show(spans) {
    this.state.spans = spans;
    this.state.rooms.add(spans.map(span => span.place));
    this.page.show();
  }

  change(spans) {
    if (spans === this.history.spans) return;
    this.history.push(spans);
    this.show(spans);
    this.tellDraft();
  }

  tellDraft() {
    this.page.say(this.isSaved ? "" : "Not saved yet");
    api.keepDraft(this.recording.page, this.history.spans, this.isSaved)
        .catch(problem => this.page.say(problem.message, true));
  }

  undo() {
    this.history.undo();
    this.show(this.history.spans);
    this.tellDraft();
  }

  redo() {
    this.history.redo();
    this.show(this.history.spans);
    this.tellDraft();
  }

  /// Labels the selection or, without one, from the frame shown to the next border. "" clears
  /// labels.
  label(place) {
    const {state} = this;
    if (state.selection) {
      const {from, to} = state.selection;
      state.selection = null;
      this.change(paint(state.spans, from, to, place));
      return;
    }
    const number = state.frames.at(state.cursor);
    const from = state.frames.before(number, state.spans);
    const to = endOfStretch(state.spans, state.frames.times[number], this.recording.duration);
    this.change(paint(state.spans, from, to, place));
  }

  /// Begins a new stretch at the frame shown.
  split() {
    const {frames, cursor, spans} = this.state;
    this.change(split(spans, frames.before(frames.at(cursor), spans)));
  }

  /// Drags a border; nothing is changed until endMove().
  move(border, target) {
    this.moving ??= border;
    const least = 1e-3;
    this.state.spans = moveBorder(this.history.spans, this.moving, target, this.recording.duration,
                                  least);
    this.page.seek(target);
  }

  endMove() {
    this.moving = null;
    this.change(this.state.spans);
  }

  cancelMove() {
    this.moving = null;
    this.show(this.history.spans);
  }

  /// Asks for a room's new name.
  rename(old) {
    const {rooms} = this.state;
    const name = tidyName(prompt("New name of the room", old) ?? old);
    if (name === old || this.complain(name)) return;
    rooms.names[rooms.names.indexOf(old)] = name;
    rooms.names = [...new Set(rooms.names)];
    this.change(this.history.spans.map(span => span.place === old ? {...span, place: name} : span));
    this.page.show();
  }

  /// Shows what is wrong with a room's name. Returns whether the name is invalid.
  complain(name) {
    const fault = faultOfName(name);
    const twin = twinOf(name, this.state.rooms.names);
    if (fault) this.page.say(fault, true);
    else if (twin) this.page.say(`“${twin}” differs only in case; the two remain separate rooms.`);
    else this.page.say("");
    return Boolean(fault);
  }

  /// Writes the labels files. Asks before it overwrites changes that were made elsewhere.
  async save() {
    const spans = this.history.spans;
    const write = overwrite => api.saveSpans(this.recording.page, spans, overwrite);
    try {
      const {files} = await write(false).catch(problem => {
        if (problem.status === 409 && confirm(`${problem.message} Overwrite?`)) return write(true);
        throw problem;
      });
      this.saved = spans;
      this.page.say(`Saved: ${files.join(", ")}`);
    } catch (problem) {
      this.page.say(problem.message, true);
    }
    this.page.show();
  }
}
