// The page's requests to its server. All addresses are relative and so contain the token.

/// Returns the parsed JSON response. Throws {message, status}.
async function ask(address, options) {
  const answer = await fetch(address, options).catch(() => {
    throw {message: "place_tool has ended; unsaved changes are lost.", status: 0};
  });
  const refused = {problem: `The server refused the request (status ${answer.status}).`};
  const value = await answer.json().catch(() => refused);
  if (!answer.ok) throw {message: value.problem, status: answer.status};
  return value;
}

const post = (name, value) => ask(name, {method: "POST", body: JSON.stringify(value)});

export const getRecording = () => ask("recording");
export const getTimes = topic => ask(`times?topic=${encodeURIComponent(topic)}`);
export const getAnswers = (question, after) => ask(`answers?question=${question}&after=${after}`);
export const saveSpans = (page, spans, overwrite) => post("save", {page, spans, overwrite});
export const keepDraft = (page, spans, saved) => post("draft", {page, spans, saved});
export const learn = (spans, topic) => post("learn", {spans, topic});

/// Tells the server that the page is open, and calls onStatus whenever the model's status changes.
export function listen(onStatus, onLost) {
  const events = new EventSource("events");
  events.onmessage = event => onStatus(JSON.parse(event.data));
  events.onerror = onLost;
  addEventListener("pagehide", () => {
    events.close();
    navigator.sendBeacon("goodbye", "{}");
  });
}
