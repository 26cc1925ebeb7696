// Labels as spans {from, to, place} of time, s, in order and without overlap. The functions return
// new lists and do not modify the old ones, so a list can be kept for undo.

/// Returns the index of the span that contains `time`, or -1.
export function spanAt(spans, time) {
  let low = 0, high = spans.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (spans[middle].to <= time) low = middle + 1; else high = middle;
  }
  return low < spans.length && spans[low].from <= time ? low : -1;
}

/// Labels everything between `from` and `to` with `place`; "" removes the labels. Merges adjacent
/// spans of the same place.
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

/// Labels what is not labelled between `from` and `to` with `place`.
export function fill(spans, from, to, place) {
  const inside = borders(spans).filter(border => from < border && border < to);
  const ends = [from, ...inside, to];
  return ends.slice(1).reduce((filled, end, i) =>
      spanAt(spans, ends[i]) < 0 ? paint(filled, ends[i], end, place) : filled, spans);
}

/// Splits the span that contains `time` in two.
export function split(spans, time) {
  const at = spanAt(spans, time);
  if (at < 0 || spans[at].from >= time) return spans;
  const {from, to, place} = spans[at];
  return [...spans.slice(0, at), {from, to: time, place}, {from: time, to, place},
          ...spans.slice(at + 1)];
}

/// Returns the times at which a label begins or ends, ascending, without duplicates.
export function borders(spans) {
  const times = [];
  for (const span of spans) {
    if (times.at(-1) !== span.from) times.push(span.from);
    times.push(span.to);
  }
  return times;
}

/// Returns the end of the stretch, labelled or not, that contains `time`.
export function endOfStretch(spans, time, duration) {
  return borders(spans).find(border => border > time) ?? duration;
}

/// Moves the border at `time` to `target`, but not past its neighbours. `least`: shortest length
/// that a stretch may be left with, s.
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

/// The history of the list of spans, for undo and redo.
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
