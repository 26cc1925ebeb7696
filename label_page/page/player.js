// The image at the cursor, and playback.

const kSpeeds = [1, 4];  // playback speeds; pressing the button again selects the next one

export class Player {
  /// `img`: the element that shows the frame; `seek(time)` moves the cursor; `button` shows the
  /// playback state.
  constructor(img, getState, seek, button) {
    Object.assign(this, {img, getState, seek, button});
    this.speed = 0;
    this.loading = false;
    this.missed = false;  // the cursor has moved while an image was loading
  }

  /// Shows the frame at the cursor. Skips frames that the cursor passes while an image is loading.
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
      this.img.classList.toggle("missing", !image.naturalWidth);
      if (image.naturalWidth) this.img.src = url;
      if (this.missed) {
        this.missed = false;
        this.show();
      }
    };
    image.src = url;
  }

  /// Switches from paused to playing, to playing faster, to paused.
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
    // When drawing is slow, playback slows down rather than skipping many frames.
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
