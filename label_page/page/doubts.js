// Finds where the model doubts or contradicts the labels.
//
// An answer is [time, place or "", {place: probability}, probability that none of its rooms is
// shown].

import {spanAt} from "./spans.js";

// A label is questioned if the probability that it is wrong exceeds this: contradicted if the model
// names another room, otherwise doubted.
const kSure = 0.5;
// Frames this far apart or further do not belong to one stretch, s.
const kGap = 3;

function verdict(answer, label) {
  const [, place, probabilities, none] = answer;
  if (!label) return place ? {kind: "unlabelled", fraction: probabilities[place] ?? 0} : null;
  const wrong = 1 - (probabilities[label] ?? 0);
  if (wrong <= kSure) return null;
  return {kind: place && place !== label ? "contradicts" : "doubts", fraction: wrong, none};
}

/// Returns stretches {kind, from, to, place, label, fraction, seconds}, worst first and unlabelled
/// ones last. `kind`: contradicts, doubts or unlabelled; `place`: the model's answer; `fraction`:
/// mean probability that the label is wrong or, without a label, that the answer is right;
/// `seconds`: that fraction of the stretch's length. `kept`: [from, to, label] that the user has
/// confirmed.
export function findDoubts(answers, spans, kept, frames) {
  const stretches = [];
  let current = null, last = -Infinity;
  for (const answer of answers) {
    const [time, place] = answer;
    const at = spanAt(spans, time);
    const label = at < 0 ? "" : spans[at].place;
    const found = verdict(answer, label);
    const fine = !found || kept.some(([from, to, right]) => right === label && from <= time &&
                                     time < to);
    const goes_on = current && !fine && current.kind === found.kind && current.label === label &&
        current.place === place && time - last < kGap;
    if (!goes_on) {
      current = fine ? null : {kind: found.kind, place, label, first: time, fraction: 0, count: 0};
      if (current) stretches.push(current);
    }
    if (current) {
      current.last = time;
      current.fraction += found.fraction;
      ++current.count;
    }
    last = time;
  }
  for (const stretch of stretches) {
    stretch.from = frames.before(frames.at(stretch.first), spans);
    stretch.to = frames.before(frames.at(stretch.last) + 1, spans);
    stretch.fraction /= stretch.count;
    stretch.seconds = stretch.fraction * (stretch.to - stretch.from);
  }
  const rank = stretch => stretch.kind === "unlabelled" ? 1 : 0;
  return stretches.filter(stretch => stretch.to > stretch.from)
      .sort((a, b) => rank(a) - rank(b) || b.seconds - a.seconds);
}
