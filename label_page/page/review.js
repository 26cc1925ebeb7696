// Going through what the model says: its answers as they come, and the stretches that it doubts.

import {getAnswers} from "./api.js";
import {findDoubts} from "./doubts.js";
import {paint} from "./spans.js";

export class Review {
  /// `page`: change(spans), show(), showStretch(from, to).
  constructor(state, page) {
    Object.assign(this, {state, page});
    this.kept = [];  // [from, to, label] that a person has found right
    this.fetching = false;
  }

  /// Finds the doubts about the labels as they are now.
  update() {
    const {state} = this;
    state.doubts = findDoubts(state.answers, state.spans, this.kept, state.frames);
    state.chosen = Math.min(state.chosen, state.doubts.length - 1);
  }

  /// Goes to one of the doubts.
  choose(number) {
    const doubt = this.state.doubts[number];
    if (!doubt) return;
    this.state.chosen = number;
    this.page.showStretch(doubt.from, doubt.to);
  }

  step(count) { this.choose(Math.max(0, this.state.chosen + count)); }

  /// Takes the model's answer.
  accept(doubt) {
    this.state.selection = null;
    this.page.change(paint(this.state.spans, doubt.from, doubt.to, doubt.place));
  }

  /// The label is right.
  keep(doubt) {
    if (doubt.kind === "unlabelled") return;
    this.state.selection = null;
    this.kept.push([doubt.from, doubt.to, doubt.label]);
    this.page.show();
  }

  /// Accepts or keeps the chosen stretch and goes on to the next one.
  settle(how) {
    const {chosen, doubts} = this.state;
    if (!doubts[chosen]) return;
    this[how](doubts[chosen]);
    this.choose(Math.min(chosen, this.state.doubts.length - 1));
  }

  /// Gives what has no label the model's answer.
  acceptRest() {
    const open = this.state.doubts.filter(doubt => doubt.kind === "unlabelled");
    this.page.change(open.reduce(
        (spans, {from, to, place}) => paint(spans, from, to, place), this.state.spans));
  }

  /// Takes the model's status, and fetches the answers that it tells of.
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
