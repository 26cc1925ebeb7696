// The rooms: their names, keys and colours.

const kKeys = [..."123456789abcdefghijklmnopqrstuvwxyz"];
const kMaxBytes = 128;

// Told apart also by people who confuse red and green, on a dark ground.
const kColours = ["#4e9de0", "#f0a23a", "#58b368", "#e0607e", "#a98be0", "#d9d05a", "#4fc1c0",
                  "#c98a5e", "#e58fd0", "#93b84f", "#7fa7b8", "#e07b53"];

export class Rooms {
  constructor() { this.names = []; }

  /// Adds those of `names` that are new.
  add(names) {
    for (const name of names) if (!this.names.includes(name)) this.names.push(name);
  }

  /// Of a room; dark for "", grey for one that is not in the list.
  colour(name) {
    const i = this.names.indexOf(name);
    if (i < 0) return name ? "#6b717c" : "#3a3f48";
    return kColours[i] ?? `hsl(${(i * 137.5) % 360} 55% ${52 + 9 * (i % 3)}%)`;
  }

  key(name) { return kKeys[this.names.indexOf(name)] ?? ""; }
  ofKey(key) { return this.names[kKeys.indexOf(key)]; }
}

/// As place_tool keeps it: composed (NFC), without characters that show nothing, blanks of any kind
/// single ones and none at the ends. tidy_name() in labels_file.py does the same.
export function tidyName(text) {
  const visible = text.replace(/[\u00ad\u200b\u200e\u200f\u202a-\u202e\u2060-\u2064\u2066-\u2069\ufeff]/g, "");
  return visible.normalize("NFC").trim().replace(/\p{Zs}+/gu, " ");
}

/// What is wrong with a name, for a person; "" if nothing is.
export function faultOfName(name) {
  const bytes = new TextEncoder().encode(name).length;
  if (!name) return "A room has a name.";
  if (bytes > kMaxBytes) return `A name has at most ${kMaxBytes} bytes; this one has ${bytes}.`;
  if (/[\p{Cc}\p{Cs}]/u.test(name)) return "A name has no control characters.";
  if (name.toLowerCase() === "unknown") {
    return "“unknown” is reserved for unknown places; leave them unlabelled.";
  }
  return "";
}

/// A room of the same letters in other case, or undefined.
export function twinOf(name, names) {
  return names.find(other => other !== name &&
                    other.toLocaleLowerCase() === name.toLocaleLowerCase());
}
