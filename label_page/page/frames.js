// The frames of a topic: their times and images.

/// Returns the index of the first of the ascending `times` that is not before `time`.
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

  /// Returns the number of the frame shown at `time`: the last one that is not later.
  at(time) { return Math.max(0, firstFrom(this.times, time + 1e-9) - 1); }

  /// Returns the border before frame `number`: a border of `spans` if one lies between the frame
  /// and its predecessor, otherwise the middle between the two. 0 before the first frame, the
  /// duration after the last.
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

  /// Returns the border between frames, as given by before(), that is nearest to `time`.
  nearestBorder(time, spans) {
    const after = firstFrom(this.times, time);
    return [after - 1, after, after + 1].map(number => this.before(number, spans)).reduce(
        (best, border) => Math.abs(border - time) < Math.abs(best - time) ? border : best);
  }

  url(number, size) {
    return `picture?topic=${encodeURIComponent(this.topic)}&frame=${number}&size=${size}`;
  }
}

/// Loads the thumbnails in view, a few at a time, and keeps the most recently used ones.
export class Thumbnails {
  constructor(onLoad) {
    this.onLoad = onLoad;
    this.images = new Map();  // url -> Image, least recently used first
    this.wanted = [];
    this.loading = 0;
  }

  static kKept = 1500;
  static kAtOnce = 4;

  /// Replaces the queue of thumbnails to load by `urls`, in this order.
  want(urls) {
    this.wanted = urls.filter(url => !this.images.has(url));
    this.loadNext();
  }

  /// Returns the image; null if it cannot be decoded, undefined if it is not loaded yet.
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
