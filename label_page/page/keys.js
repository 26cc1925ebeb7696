// What the keys do. Letters and digits belong to the rooms.

const kKeys = [
  ["1 … 9, a … z", "this room: the selected stretch, or from here to the next border"],
  ["0, Delete", "no room, likewise"],
  ["/", "split the label here"],
  ["← →", "one frame back or on; with Shift one second, with Ctrl to the next border"],
  ["Space", "play or pause"],
  [". ,", "next or previous stretch that the model doubts"],
  ["Enter", "take the model's answer for that stretch"],
  ["Backspace", "keep the label of that stretch"],
  ["+ −", "closer or further; the mouse wheel does so, too, and with Shift moves the strip"],
  ["=", "the whole recording"],
  ["Home, End", "first or last frame"],
  ["Esc", "select nothing"],
  ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["Ctrl+S", "save"],
  ["Mouse", "dragging along the strip selects; dragging a border of a label moves it; a click on a "
            + "label selects it"],
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

/// Calls what `on` has for a key.
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
    if (button) return;  // they press it
    const work = held ? control[event.key]
        : (event.shiftKey && shifted[event.key]) || plain[event.key] ||
          (/^[1-9a-z]$/.test(event.key) ? () => on.label(event.key) : undefined);
    if (!work) return;
    event.preventDefault();
    work();
  });
}
