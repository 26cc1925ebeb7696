// The part of the recording in view, and the canvases that show it.

/// Margin to the left and right of the recording when all of it is in view, pixels.
export const kMargin = 12;

/// Gives a canvas the resolution of the screen and clears it. Returns its context and size in CSS
/// pixels.
export function prepare(canvas) {
  const ratio = devicePixelRatio || 1;
  const {clientWidth: width, clientHeight: height} = canvas;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return {context, width, height};
}

/// The part of the recording in view: `start`, the time at the left border, s; `scale`, pixels/s.
export class View {
  constructor(duration) {
    this.duration = duration;
    this.start = 0;
    this.scale = 1;
    this.width = 1;
    this.closest = 100;  // the largest scale
  }

  get least() { return Math.max(1e-3, (this.width - 2 * kMargin) / Math.max(this.duration, 1e-3)); }
  x(time) { return (time - this.start) * this.scale; }
  time(x) { return this.start + x / this.scale; }

  keepWithin() {
    this.scale = Math.min(Math.max(this.scale, this.least), Math.max(this.closest, this.least));
    const margin = kMargin / this.scale;
    const last = this.duration + margin - this.width / this.scale;
    this.start = Math.max(-margin, Math.min(this.start, Math.max(last, -margin)));
  }

  zoom(factor, x) {
    const time = this.time(x);
    this.scale *= factor;
    this.keepWithin();
    this.start = time - x / this.scale;
    this.keepWithin();
  }

  showAll() {
    this.scale = 0;
    this.keepWithin();
  }

  /// Brings `time` into view.
  reveal(time) {
    const x = this.x(time);
    if (x < 20 || x > this.width - 20) this.start = time - this.width / 2 / this.scale;
    this.keepWithin();
  }

  /// Brings a stretch into view, with some of its surroundings.
  revealStretch(from, to) {
    this.scale = Math.min(this.scale, this.width / Math.max(1e-3, (to - from) * 1.6));
    this.keepWithin();
    const visible = this.x(from) > 0 && this.x(to) < this.width;
    if (!visible) this.start = (from + to - this.width / this.scale) / 2;
    this.keepWithin();
  }
}
