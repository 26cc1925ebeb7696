// Labels as spans {from, to, place} of time, s, in order and without overlap. The functions return
// new lists and leave the old ones alone, so that a list can be kept for undo.

/// The index of the span that holds `time`, or -1.
export function spanAt(spans, time) {
  let low = 0, high = spans.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (spans[middle].to <= time) low = middle + 1; else high = middle;
  }
  return low < spans.length && spans[low].from <= time ? low : -1;
}

/// Gives all between `from` and `to` the place; "" for no room. Spans of the same place that touch
/// it become one with it.
export function paint(spans, from, to, place) {
  if (!(from < to)) return spans;
  const before = [], after = [];
  for (const span of spans) {
    if (span.from < from) before.push({...span, to: Math.min(span.to, from)});
    if (span.to > to) after.push({...span, from: Math.max(span.from, to)});
  }
  if (!place) return [...before, ...after];
  const painted = {from, to, place};
  if (before.length && before.at(-1).to === from && before.at(-1).place === place) {
    painted.from = before.pop().from;
  }
  if (after.length && after[0].from === to && after[0].place === place) {
    painted.to = after.shift().to;
  }
  return [...before, painted, ...after];
}

/// Makes two spans of the one that holds `time`.
export function split(spans, time) {
  const at = spanAt(spans, time);
  if (at < 0 || spans[at].from >= time) return spans;
  const {from, to, place} = spans[at];
  return [...spans.slice(0, at), {from, to: time, place}, {from: time, to, place},
          ...spans.slice(at + 1)];
}

/// The times at which a label begins or ends, ascending, each once.
export function borders(spans) {
  const times = [];
  for (const span of spans) {
    if (times.at(-1) !== span.from) times.push(span.from);
    times.push(span.to);
  }
  return times;
}

/// Where the stretch ends that holds `time`, labelled or not.
export function endOfStretch(spans, time, duration) {
  return borders(spans).find(border => border > time) ?? duration;
}

/// Moves the border at `time` to `target`, but not past its neighbours; `least`: what is left of
/// a span at least.
export function moveBorder(spans, time, target, duration, least) {
  const all = [0, ...borders(spans).filter(border => border > 0 && border < duration), duration];
  const at = all.indexOf(time);
  if (at < 0) return spans;
  const low = at > 0 ? all[at - 1] + least : 0;
  const high = at + 1 < all.length ? all[at + 1] - least : duration;
  if (low > high) return spans;
  const moved = Math.min(Math.max(target, low), high);
  return spans.map(span => ({...span, from: span.from === time ? moved : span.from,
                             to: span.to === time ? moved : span.to}));
}

/// Lists of spans as they followed each other.
export class History {
  constructor(spans) {
    this.states = [spans];
    this.at = 0;
  }

  get spans() { return this.states[this.at]; }
  get canUndo() { return this.at > 0; }
  get canRedo() { return this.at + 1 < this.states.length; }

  push(spans) {
    this.states.length = this.at + 1;
    this.states.push(spans);
    this.at = this.states.length - 1;
  }

  undo() { if (this.canUndo) --this.at; }
  redo() { if (this.canRedo) ++this.at; }
}
