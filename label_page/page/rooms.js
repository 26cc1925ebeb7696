// The rooms' names, keys and colours.

const kKeys = [..."123456789abcdefghijklmnopqrstuvwxyz"];
const kMaxBytes = 128;

// Colours on a dark background that people with red-green colour blindness can tell apart.
const kColours = ["#4e9de0", "#f0a23a", "#58b368", "#e0607e", "#a98be0", "#d9d05a", "#4fc1c0",
                  "#c98a5e", "#e58fd0", "#93b84f", "#7fa7b8", "#e07b53"];

export class Rooms {
  constructor() { this.names = []; }

  /// Adds the `names` that are not in the list yet.
  add(names) {
    for (const name of names) if (!this.names.includes(name)) this.names.push(name);
  }

  /// Returns the colour of a room: dark grey for "", lighter grey for a room not in the list.
  colour(name) {
    const i = this.names.indexOf(name);
    if (i < 0) return name ? "#6b717c" : "#3a3f48";
    return kColours[i] ?? `hsl(${(i * 137.5) % 360} 55% ${52 + 9 * (i % 3)}%)`;
  }

  key(name) { return kKeys[this.names.indexOf(name)] ?? ""; }
  ofKey(key) { return this.names[kKeys.indexOf(key)]; }
}

/// Returns a name as place_tool normalizes it: in NFC, without invisible characters, with each run
/// of blanks replaced by one space, and trimmed. Keep in step with tidy_name() in labels_file.py.
export function tidyName(text) {
  const visible = text.replace(/[\u00ad\u200b\u200e\u200f\u202a-\u202e\u2060-\u2064\u2066-\u2069\ufeff]/g, "");
  return visible.normalize("NFC").trim().replace(/\p{Zs}+/gu, " ");
}

/// Returns a sentence for the user on what is wrong with a name; "" if the name is valid.
export function faultOfName(name) {
  const bytes = new TextEncoder().encode(name).length;
  if (!name) return "Enter a name for the room.";
  if (bytes > kMaxBytes) return `A name can have up to ${kMaxBytes} bytes; this one has ${bytes}.`;
  if (/[\p{Cc}\p{Cs}]/u.test(name)) return "A name must not contain control characters.";
  if (name.toLowerCase() === "unknown") {
    return "“unknown” is reserved for unknown places; leave those unlabelled.";
  }
  return "";
}

/// Returns a room whose name differs only in case, or undefined.
export function twinOf(name, names) {
  return names.find(other => other !== name &&
                    other.toLocaleLowerCase() === name.toLocaleLowerCase());
}
