// The picture at the cursor, and playing.

const kSpeeds = [1, 4];  // of playing: the second one if it is pressed again

export class Player {
  /// `seek(time)` moves the cursor, `button` says what happens.
  constructor(picture, getState, seek, button) {
    Object.assign(this, {picture, getState, seek, button});
    this.speed = 0;
    this.loading = false;
    this.missed = false;  // the cursor has moved while a picture was loading
  }

  /// Shows the frame at the cursor: of those that come faster than pictures load, the newest.
  show() {
    if (this.loading) {
      this.missed = true;
      return;
    }
    const {frames, cursor} = this.getState();
    const url = frames.url(frames.at(cursor), "view");
    if (this.url === url) return;
    this.url = url;
    this.loading = true;
    const image = new Image();
    image.onload = image.onerror = () => {
      this.loading = false;
      this.picture.classList.toggle("missing", !image.naturalWidth);
      if (image.naturalWidth) this.picture.src = url;
      if (this.missed) {
        this.missed = false;
        this.show();
      }
    };
    image.src = url;
  }

  /// Plays, plays faster, pauses.
  toggle() {
    const playing = this.speed > 0;
    this.speed = kSpeeds[this.speed ? kSpeeds.indexOf(this.speed) + 1 : 0] ?? 0;
    this.button.textContent = {0: "Play", 1: "Play ×4", 4: "Pause"}[this.speed];
    if (this.speed && !playing) {
      this.last = performance.now();
      requestAnimationFrame(now => this.advance(now));
    }
  }

  advance(now) {
    if (!this.speed) return;
    const {cursor, frames} = this.getState();
    // Pictures that load slowly slow it down instead of being skipped by the dozen.
    const elapsed = Math.min(0.2, Math.max(0, now - this.last) / 1000);
    this.last = now;
    this.seek(cursor + elapsed * this.speed);
    if (cursor >= frames.times.at(-1)) {
      this.speed = kSpeeds.at(-1);
      this.toggle();
      return;
    }
    requestAnimationFrame(next => this.advance(next));
  }
}
