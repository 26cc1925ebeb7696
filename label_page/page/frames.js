// The frames of a topic: their times and their pictures.

/// The first index of the ascending `times` that is not before `time`.
export function firstFrom(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1; else high = middle;
  }
  return low;
}

/// The frames of one topic: `times`, s, ascending, within 0..duration.
export class Frames {
  constructor(topic, times, duration) {
    Object.assign(this, {topic, times, duration});
  }

  /// The frame that is seen at `time`: the last one that is not after it.
  at(time) { return Math.max(0, firstFrom(this.times, time + 1e-9) - 1); }

  /// The border before frame `number`: one of the `spans` if there is one between it and the frame
  /// before, else half way; the start before the first, the end behind the last.
  before(number, spans = []) {
    if (number <= 0) return 0;
    if (number >= this.times.length) return this.duration;
    const low = this.times[number - 1], high = this.times[number];
    const between = border => low < border && border <= high;
    for (const span of spans) {
      if (between(span.from)) return span.from;
      if (between(span.to)) return span.to;
      if (span.from > high) break;
    }
    return (low + high) / 2;
  }

  /// The border between frames, as before() has it, that is nearest to `time`.
  nearestBorder(time, spans) {
    const after = firstFrom(this.times, time);
    return [after - 1, after, after + 1].map(number => this.before(number, spans)).reduce(
        (best, border) => Math.abs(border - time) < Math.abs(best - time) ? border : best);
  }

  url(number, size) {
    return `picture?topic=${encodeURIComponent(this.topic)}&frame=${number}&size=${size}`;
  }
}

/// Loads the thumbnails that are in view, a few at a time, and keeps the newest.
export class Thumbnails {
  constructor(onLoad) {
    this.onLoad = onLoad;
    this.images = new Map();  // url -> Image, the one used longest ago first
    this.wanted = [];
    this.loading = 0;
  }

  static kKept = 1500;
  static kAtOnce = 4;

  /// From now on only these are worth loading, the first ones first.
  want(urls) {
    this.wanted = urls.filter(url => !this.images.has(url));
    this.loadNext();
  }

  /// The picture if it is there; null if it is of no use, undefined if it has yet to come.
  get(url) {
    const image = this.images.get(url);
    if (image?.complete) {
      this.images.delete(url);
      this.images.set(url, image);
      return image.naturalWidth ? image : null;
    }
    return undefined;
  }

  loadNext() {
    while (this.loading < Thumbnails.kAtOnce && this.wanted.length) {
      const url = this.wanted.shift();
      const image = new Image();
      this.images.set(url, image);
      ++this.loading;
      image.onload = image.onerror = () => {
        --this.loading;
        this.onLoad();
        this.loadNext();
      };
      image.src = url;
    }
    for (const url of this.images.keys()) {
      if (this.images.size <= Thumbnails.kKept) break;
      this.images.delete(url);
    }
  }
}
