// The strip: a ruler, thumbnails, the labels as coloured spans, and the model's answers.

import {clock, niceStep} from "./format.js";
import {firstFrom} from "./frames.js";
import {borders, spanAt} from "./spans.js";
import {prepare} from "./view.js";

// Positions of the rows, pixels.
const kRuler = {top: 0, height: 22};
const kThumbs = {top: 24, height: 96};
const kLabels = {top: 126, height: 38};
const kAnswers = {top: 168, height: 30};
const kHeight = 206;
const kGrip = 7;  // distance from a border within which the mouse grabs it, pixels

export class Timeline {
  /// `state`: {frames, spans, answers, answerTimes, cursor, selection, rooms}; `on`: seek(time),
  /// select(from, to), move(border, target), moved(), notMoved(), viewChanged().
  constructor(canvas, state, view, thumbnails, on) {
    Object.assign(this, {canvas, state, view, thumbnails, on});
    this.aspect = 4 / 3;
    this.drag = null;
    canvas.addEventListener("pointerdown", event => this.press(event));
    canvas.addEventListener("pointermove", event => this.hover(event));
    canvas.addEventListener("pointerup", event => this.release(event));
    canvas.addEventListener("pointercancel", () => this.cancel());
    canvas.addEventListener("wheel", event => this.wheel(event), {passive: false});
  }

  draw() {
    const {context, width} = prepare(this.canvas);
    this.view.width = width;
    const interval = this.interval();
    this.view.closest = 1.02 * kThumbs.height * this.aspect / interval;
    this.view.keepWithin();
    this.drawRuler(context, width);
    this.drawThumbnails(context, width, interval);
    this.drawLabels(context);
    this.drawAnswers(context, width);
    this.drawMarks(context);
  }

  /// Returns the mean interval between frames, s.
  interval() {
    const times = this.state.frames.times;
    return times.length > 1 ? Math.max(1e-3, (times.at(-1) - times[0]) / (times.length - 1)) : 1;
  }

  drawRuler(context, width) {
    const step = niceStep(80 / this.view.scale);
    const digits = step < 0.1 ? 2 : step < 1 ? 1 : 0;
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = "#979da8";
    context.strokeStyle = "#33373f";
    context.beginPath();
    const first = Math.max(0, Math.floor(this.view.time(0) / step));
    for (let i = first; i * step <= Math.min(this.view.time(width), this.view.duration); ++i) {
      const x = Math.round(this.view.x(i * step)) + .5;
      context.moveTo(x, kRuler.top + 14);
      context.lineTo(x, kRuler.top + kRuler.height);
      context.fillText(clock(i * step, digits), x + 4, kRuler.top + 15);
    }
    context.stroke();
  }

  /// Returns the positions of the thumbnails: {number, x, width}. If there are more frames in view
  /// than fit, the grid is anchored in time and its step is a power of two seconds, so the same
  /// frames stay visible while the strip scrolls.
  slots(width, interval) {
    const {view, state: {frames}} = this;
    const full = kThumbs.height * this.aspect;
    const step = Math.max(interval, 2 ** Math.floor(Math.log2(full / view.scale)));
    const single = step < 2 * interval;  // one slot per frame
    const slots = [];
    const add = (number, from, to) => slots.push(
        {number, x: view.x(from), width: Math.min(full, (to - from) * view.scale)});
    if (single) {
      const times = frames.times;
      for (let i = frames.at(view.time(-full)); i < times.length; ++i) {
        if (view.x(times[i]) > width) break;
        if (slots.length && view.x(times[i]) - slots.at(-1).x < full / 2 - 1) continue;
        add(i, times[i], Math.min(times[i + 1] ?? Infinity, times[i] + 2 * full / view.scale));
      }
      slots.forEach((slot, i) => {
        slot.width = Math.min(full, (slots[i + 1]?.x ?? Infinity) - slot.x);
      });
      return slots;
    }
    for (let i = Math.max(0, Math.floor(view.time(0) / step)); view.x(i * step) < width; ++i) {
      const number = firstFrom(frames.times, i * step), end = (i + 1) * step;
      if (number >= frames.times.length) break;
      if (frames.times[number] < end) add(number, i * step, Math.min(end, view.duration));
    }
    return slots;
  }

  drawThumbnails(context, width, interval) {
    const {top, height} = kThumbs;
    const slots = this.slots(width, interval);
    const urls = slots.map(slot => this.state.frames.url(slot.number, "thumb"));
    slots.forEach((slot, i) => {
      const image = this.thumbnails.get(urls[i]);
      context.save();
      context.beginPath();
      context.rect(slot.x, top, slot.width - 1, height);
      context.clip();
      context.fillStyle = "#262a30";
      context.fillRect(slot.x, top, slot.width, height);
      if (image) {
        this.aspect = image.naturalWidth / image.naturalHeight;
        const shown = height * this.aspect;
        context.drawImage(image, slot.x + (slot.width - shown) / 2, top, shown, height);
      } else if (image === null) {
        context.strokeStyle = "#a04848";
        context.beginPath();
        context.moveTo(slot.x, top);
        context.lineTo(slot.x + slot.width, top + height);
        context.stroke();
      }
      context.restore();
    });
    const middle = width / 2;  // thumbnails in the middle are loaded first
    const order = slots.map((slot, i) => i).sort(
        (a, b) => Math.abs(slots[a].x - middle) - Math.abs(slots[b].x - middle));
    this.thumbnails.want(order.map(i => urls[i]));
  }

  drawLabels(context) {
    const {top, height} = kLabels;
    const {spans, rooms} = this.state;
    const right = this.view.x(this.view.duration);
    context.fillStyle = "#24272d";
    context.fillRect(this.view.x(0), top, right - this.view.x(0), height);
    context.font = "600 13px system-ui, sans-serif";
    for (const span of spans) {
      const x = this.view.x(span.from), end = this.view.x(span.to);
      if (end < 0 || x > this.view.width) continue;
      context.fillStyle = rooms.colour(span.place);
      context.fillRect(x, top, Math.max(1, end - x - 1), height);
      const visible = Math.max(x, 0), space = Math.min(end, this.view.width) - visible - 14;
      if (space < 16) continue;
      context.save();
      context.beginPath();
      context.rect(visible, top, space + 10, height);
      context.clip();
      context.fillStyle = "#10131a";
      context.fillText(span.place, visible + 7, top + 24);
      context.restore();
    }
    context.fillStyle = "rgb(255 255 255 / .75)";
    for (const border of borders(spans)) {
      context.fillRect(this.view.x(border) - 1.5, top, 2, height);
    }
  }

  /// Draws one column per pixel, coloured by the answer; its height is proportional to the answer's
  /// probability.
  drawAnswers(context, width) {
    const {top, height} = kAnswers;
    const {answers, rooms, spans} = this.state;
    const times = this.state.answerTimes;
    if (!answers.length) return;
    const end = Math.min(width, this.view.x(this.view.duration));
    for (let x = 0; x < end; ++x) {
      const from = firstFrom(times, this.view.time(x));
      const at = firstFrom(times, this.view.time(x + 1)) > from ? from : from - 1;
      if (at < 0 || this.view.time(x) - times[at] > 2) continue;
      const [, place, probabilities] = answers[at];
      const fraction = place ? probabilities[place] ?? 0 : 0.25;
      const h = Math.max(3, height * fraction);
      context.fillStyle = place ? rooms.colour(place) : "#5a606b";
      context.fillRect(x, top + height - h, 1, h);
      const label = spanAt(spans, times[at]);
      if (label >= 0 && place !== spans[label].place) {
        context.fillStyle = place ? "#ff5c5c" : "#b9933f";
        context.fillRect(x, top + height + 2, 1, 4);
      }
    }
  }

  drawMarks(context) {
    const {selection, cursor} = this.state;
    const bottom = kHeight - 2;
    if (selection) {
      const x = this.view.x(selection.from), w = this.view.x(selection.to) - x;
      context.fillStyle = "rgb(90 169 255 / .25)";
      context.fillRect(x, kThumbs.top, w, bottom - kThumbs.top);
      context.strokeStyle = "#5aa9ff";
      context.lineWidth = 2;
      context.strokeRect(x, kThumbs.top, w, bottom - kThumbs.top);
      context.lineWidth = 1;
    }
    const x = this.view.x(cursor);
    context.fillStyle = "#ffffff";
    context.fillRect(x - 1, kRuler.top + 8, 2, bottom - 8);
    context.beginPath();
    context.moveTo(x - 6, kRuler.top + 4);
    context.lineTo(x + 6, kRuler.top + 4);
    context.lineTo(x, kRuler.top + 13);
    context.fill();
  }

  // Pointer

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  }

  /// Returns the border under the pointer, or undefined.
  borderAt({x, y}) {
    if (y < kLabels.top || y > kLabels.top + kLabels.height) return undefined;
    const near = borders(this.state.spans)
        .map(border => ({border, off: Math.abs(this.view.x(border) - x)}))
        .filter(({border, off}) => off <= kGrip && border > 0 && border < this.view.duration);
    return near.sort((a, b) => a.off - b.off)[0]?.border;
  }

  press(event) {
    if (event.button !== 0) return;
    const at = this.place(event);
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus();
    const border = this.borderAt(at);
    if (border !== undefined) this.drag = {kind: "border", border};
    else if (at.y < kThumbs.top) this.drag = {kind: "scrub"};
    else this.drag = {kind: "select", x: at.x, row: at.y};
    if (this.drag.kind === "scrub") this.on.seek(this.view.time(at.x));
  }

  hover(event) {
    const at = this.place(event);
    if (!this.drag) {
      const grip = this.borderAt(at) !== undefined;
      this.canvas.style.cursor = grip ? "ew-resize" : at.y < kThumbs.top ? "default" : "crosshair";
      return;
    }
    if (this.drag.kind === "scrub") this.on.seek(this.view.time(at.x));
    if (this.drag.kind === "border") this.on.move(this.drag.border, this.snapped(at.x));
    if (this.drag.kind === "select" && Math.abs(at.x - this.drag.x) > 3) {
      const [from, to] = [this.drag.x, at.x].sort((a, b) => a - b).map(x => this.snapped(x));
      this.drag.moved = true;
      this.on.select(from, to);
    }
  }

  cancel() {
    if (this.drag?.kind === "border") this.on.notMoved();
    this.drag = null;
  }

  release(event) {
    const drag = this.drag;
    this.drag = null;
    if (!drag) return;
    if (drag.kind === "border") this.on.moved();
    if (drag.kind !== "select" || drag.moved) return;
    const time = this.view.time(this.place(event).x);
    this.on.seek(time);
    const at = spanAt(this.state.spans, time);
    const on_labels = drag.row >= kLabels.top && drag.row <= kLabels.top + kLabels.height;
    if (on_labels && at >= 0) this.on.select(this.state.spans[at].from, this.state.spans[at].to);
    else this.on.select(0, 0);
  }

  snapped(x) {
    const time = this.view.time(x);
    return this.state.frames.nearestBorder(time, this.state.spans);
  }

  wheel(event) {
    event.preventDefault();
    const pan = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
    const delta = (event.deltaY || event.deltaX) * (event.deltaMode ? 30 : 1);
    if (pan) {
      this.view.start += (event.deltaX || event.deltaY) / this.view.scale;
      this.view.keepWithin();
    } else {
      this.view.zoom(Math.exp(-delta / 400), this.place(event).x);
    }
    this.on.viewChanged();
  }
}
