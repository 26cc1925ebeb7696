// Review of the model's opinion: receives its answers and steps through the stretches that it
// questions.

import {getAnswers} from "./api.js";
import {findDoubts} from "./doubts.js";
import {fill, paint} from "./spans.js";

export class Review {
  /// `page`: change(spans), show(), showStretch(from, to).
  constructor(state, page) {
    Object.assign(this, {state, page});
    this.kept = [];  // [from, to, label] that the user has confirmed
    this.fetching = false;
  }

  /// Finds the doubts about the current labels.
  update() {
    const {state} = this;
    const chosen = state.doubts[state.chosen];
    state.doubts = findDoubts(state.answers, state.spans, this.kept, state.frames);
    // The list is sorted anew; a stretch that has gone is no longer chosen.
    state.chosen = state.doubts.findIndex(doubt => chosen && doubt.from === chosen.from &&
                                                   doubt.label === chosen.label);
  }

  /// Chooses a doubt and shows its stretch.
  choose(number) {
    const doubt = this.state.doubts[number];
    if (!doubt) return;
    this.state.chosen = number;
    this.page.showStretch(doubt.from, doubt.to);
  }

  step(count) { this.choose(Math.max(0, this.state.chosen + count)); }

  /// The labels with the model's answer instead of the doubtful label. A stretch without a label
  /// may reach into labels between its frames, which stay.
  answered(spans, {kind, from, to, place}) {
    return kind === "unlabelled" ? fill(spans, from, to, place) : paint(spans, from, to, place);
  }

  /// Replaces the label by the model's answer.
  accept(doubt) {
    this.state.selection = null;
    this.page.change(this.answered(this.state.spans, doubt));
  }

  /// Confirms the label.
  keep(doubt) {
    if (doubt.kind === "unlabelled") return;
    this.state.selection = null;
    this.kept.push([doubt.from, doubt.to, doubt.label]);
    this.page.show();
  }

  /// Accepts or keeps the chosen stretch (`how`: "accept" or "keep") and chooses the next one.
  settle(how) {
    const {chosen, doubts} = this.state;
    if (!doubts[chosen]) return;
    this[how](doubts[chosen]);
    this.choose(Math.min(chosen, this.state.doubts.length - 1));
  }

  /// Labels all unlabelled stretches with the model's answers.
  acceptRest() {
    const open = this.state.doubts.filter(doubt => doubt.kind === "unlabelled");
    this.page.change(open.reduce(this.answered, this.state.spans));
  }

  /// Stores the model's status and fetches the answers that it announces.
  async hear(status) {
    const {state} = this;
    state.status = status;
    if (status.question !== state.question) {
      Object.assign(state, {question: status.question, answers: [], answerTimes: []});
    }
    while (!this.fetching && state.answers.length < state.status.answers) {
      this.fetching = true;
      const question = state.question;
      const answers = await getAnswers(question, state.answers.length).catch(() => []);
      this.fetching = false;
      if (question !== state.question || !answers.length) break;
      for (const answer of answers) {
        state.answers.push(answer);
        state.answerTimes.push(answer[0]);
        state.rooms.add(Object.keys(answer[2]));
      }
    }
    this.page.show();
  }
}
