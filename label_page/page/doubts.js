// Where the model doubts or contradicts the labels.
//
// An answer is [time, place or "", {place: probability}, probability of none of its rooms].

import {spanAt} from "./spans.js";

// A label less probable than this is contradicted, or doubted if the model knows no better.
const kSure = 0.5;
// Frames further apart do not belong to one stretch, s.
const kGap = 3;

function verdict(answer, label) {
  const [, place, probabilities, none] = answer;
  if (!label) return place ? {kind: "unlabelled", fraction: probabilities[place] ?? 0} : null;
  const wrong = 1 - (probabilities[label] ?? 0);
  if (wrong <= kSure) return null;
  return {kind: place && place !== label ? "contradicts" : "doubts", fraction: wrong, none};
}

/// Stretches of {kind, from, to, place, label, fraction, seconds}: `kind` contradicts, doubts or
/// unlabelled; `place`: the model's answer; `fraction`: how probable it is that the label is wrong, or
/// that the answer is right where there is no label; `seconds`: as much of the stretch. The worst
/// first; those without a label last. `kept`: [from, to, label] that a person has found right.
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
