// The keyboard shortcuts. Letters and digits are reserved for the rooms.

const kKeys = [
  ["1 … 9, a … z", "label the selected stretch, or from here to the next border, with this room"],
  ["0, Delete", "remove the label in the same range"],
  ["/", "split the label here"],
  ["← →", "back or forward by one frame; with Shift by one second, with Ctrl to the next border"],
  ["Space", "play, play faster or pause"],
  [". ,", "next or previous stretch that the model questions"],
  ["Enter", "accept the model's answer for that stretch"],
  ["Backspace", "keep the label of that stretch"],
  ["+ −", "zoom in or out; so does the mouse wheel, which scrolls the strip with Shift"],
  ["=", "show the whole recording"],
  ["Home, End", "first or last frame"],
  ["Esc", "clear the selection"],
  ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["Ctrl+S", "save"],
  ["Mouse", "drag along the strip to select; drag the border of a label to move it; click a label "
            + "to select it"],
];

export function listKeys(table) {
  for (const [keys, meaning] of kKeys) {
    const row = table.insertRow();
    row.insertCell().append(...keys.split(", ").flatMap((key, i) => {
      const kbd = Object.assign(document.createElement("kbd"), {textContent: key});
      return i ? [" ", kbd] : [kbd];
    }));
    row.insertCell().textContent = meaning;
  }
}

/// Calls the handler in `on` for each key that is pressed.
export function onKeys(on) {
  const plain = {
    "0": on.clear, Delete: on.clear, "/": on.split, " ": on.play, Enter: on.accept,
    Backspace: on.keep, ".": () => on.doubt(1), ",": () => on.doubt(-1), "+": () => on.zoom(1.6),
    "-": () => on.zoom(1 / 1.6), "=": () => on.zoom(0), Home: on.start, End: on.end,
    Escape: on.deselect, "?": on.help,
    ArrowLeft: () => on.step(-1), ArrowRight: () => on.step(1),
  };
  const shifted = {ArrowLeft: () => on.second(-1), ArrowRight: () => on.second(1)};
  const control = {
    z: on.undo, y: on.redo, Z: on.redo, s: on.save,
    ArrowLeft: () => on.stepBorder(-1), ArrowRight: () => on.stepBorder(1),
  };
  addEventListener("keydown", event => {
    if (event.target.closest("input, select, dialog") || event.altKey || event.isComposing) return;
    const held = event.ctrlKey || event.metaKey;
    const button = event.target.closest("button") && [" ", "Enter"].includes(event.key);
    if (button) return;  // the keys press the button
    const work = held ? control[event.key]
        : (event.shiftKey && shifted[event.key]) || plain[event.key] ||
          (/^[1-9a-z]$/.test(event.key) ? () => on.label(event.key) : undefined);
    if (!work) return;
    event.preventDefault();
    work();
  });
}
