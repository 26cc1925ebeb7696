import {kMargin, prepare} from "./view.js";

/// The bar that shows the whole recording: its labels, the contradicted stretches and the part in
/// view.
export class Overview {
  constructor(canvas, state, view, onView) {
    Object.assign(this, {canvas, state, view, onView});
    const go = event => {
      if (!(event.buttons & 1)) return;
      const fraction = (event.offsetX - kMargin) / (canvas.clientWidth - 2 * kMargin);
      view.start = fraction * view.duration - view.width / view.scale / 2;
      view.keepWithin();
      onView();
    };
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    canvas.addEventListener("pointermove", go);
  }

  draw() {
    const {context, width, height} = prepare(this.canvas);
    const scale = (width - 2 * kMargin) / Math.max(this.view.duration, 1e-3);
    const x = time => kMargin + time * scale;
    context.fillStyle = "#24272d";
    context.fillRect(kMargin, 7, width - 2 * kMargin, height - 14);
    for (const span of this.state.spans) {
      context.fillStyle = this.state.rooms.colour(span.place);
      context.fillRect(x(span.from), 7, Math.max(.5, (span.to - span.from) * scale), height - 14);
    }
    context.fillStyle = "#ff5c5c";
    for (const doubt of this.state.doubts) {
      if (doubt.kind === "contradicts") {
        const length = Math.max(2, (doubt.to - doubt.from) * scale);
        context.fillRect(x(doubt.from), height - 5, length, 3);
      }
    }
    const left = x(Math.max(0, this.view.start));
    const right = x(Math.min(this.view.duration, this.view.time(this.view.width)));
    context.strokeStyle = "#ffffff";
    context.strokeRect(left + .5, 3.5, Math.max(4, right - left) - 1, height - 7);
    context.fillStyle = "#ffffff";
    context.fillRect(x(this.state.cursor) - .5, 3, 1, height - 6);
  }
}
