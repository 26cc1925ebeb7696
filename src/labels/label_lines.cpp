#include "labels/label_lines.h"

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <utility>

#include "base/atomic_file.h"
#include "base/file_kind.h"
#include "base/place_name.h"
#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxFileBytes = 64 << 20;

const char* const kWanted = "'timestamp label', such as '1700000000.5 kitchen'";

/// A line before the unit of its timestamp is known.
struct RawLine {
  double time = 0;
  char separator = ' ';  // ' ' also represents tabs
  std::string label;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// Replaces blanks that are not plain spaces, which word processors and web pages insert. A tab at
/// the end of a line still ends a column.
std::string withPlainBlanks(const std::string& line) {
  const bool ends_column = !line.empty() && line.back() == '\t';
  return placeName(line) + (ends_column ? "\t" : "");
}

bool isNumber(const std::string& text) {
  static const std::regex number(R"([+-]?\d+([.,]\d+)?([eE][+-]?\d+)?)");
  return text.size() < 40 && std::regex_match(text, number);
}

/// Whether a line contains column headings: its first word refers to time.
bool isHeader(const std::string& line) {
  const std::string word = caseFolded(line.substr(0, line.find_first_of(",;\t ", 1)));
  const auto says = [&word](const char* text) { return word.find(text) != std::string::npos; };
  return says("time") || says("stamp") || says("sec") || word == "t" || word == "\"t\"";
}

/// The only field of `text`, which follows the separator; it may be quoted, and followed by empty
/// fields.
std::string onlyField(const std::string& text, char separator, const std::string& where) {
  std::string field;
  std::string rest = trimmed(text);
  if (!rest.empty() && rest[0] == '"') {
    std::size_t i = 1;
    for (; i < rest.size() && (rest[i] != '"' || rest.compare(i, 2, "\"\"") == 0); ++i) {
      if (rest[i] == '"') ++i;
      field += rest[i];
    }
    if (i >= rest.size()) throw Error(where + " has an unclosed quote; close it.");
    rest = trimmed(rest.substr(i + 1));
    if (!rest.empty() && rest[0] != separator) {
      throw Error(where + " has text after its quotes; write " + std::string(kWanted) + ".");
    }
  } else {
    field = trimmed(rest.substr(0, rest.find(separator)));
    rest.erase(0, rest.find(separator));
  }
  if (rest.find_first_not_of(std::string(" \t") + separator) != std::string::npos) {
    throw Error(where + " has more than two columns; leave only " + kWanted +
                " (put a name with '" + separator + "' in double quotes).");
  }
  return field;
}

/// The part of a line that is searched for patterns; std::regex recurses on each letter.
std::string headOf(const std::string& line) { return line.substr(0, 100); }

[[noreturn]] void refuseSpan(const std::string& where) {
  throw Error(where + " may also contain an end time; write " + kWanted +
              ", each label with its start, or intervals in RUN.labels.yaml: {from: ..., to: "
              "..., place: ...}. Put a name with such a number in double quotes.");
}

/// A number that no room has.
bool isTime(const std::string& word) {
  constexpr double kNoRoomNumber = 100000;
  return isNumber(word) && std::atof(word.c_str()) >= kNoRoomNumber;
}

[[noreturn]] void refuseNanoseconds(const std::string& where) {
  throw Error(where + " may have the nanoseconds of its timestamp in a separate column; write " +
              kWanted +
              ", with one number. Put a name that begins with such a number in double quotes.");
}

/// Checks that a label without quotes contains no part of a time, such as the end of an interval.
void requireNoTime(const std::string& label, double time, const std::string& where) {
  const std::string first = label.substr(0, label.find_first_of(" \t"));
  const std::string last = label.substr(label.find_last_of(" \t") + 1);
  if (isTime(first) || isTime(last)) refuseSpan(where);
  const bool is_zero = first.find_first_not_of('0') == std::string::npos;
  if (is_zero && first.size() < label.size()) refuseNanoseconds(where);
  const auto may_be_end = [time](const std::string& word) {
    return isNumber(word) && std::atof(word.c_str()) >= time;
  };
  const bool is_before_name = first.size() < label.size();
  if ((is_before_name && may_be_end(first)) ||
      (may_be_end(last) && last.find('.') != std::string::npos)) {
    refuseSpan(where);
  }
}

std::string withoutSingleQuotes(const std::string& label) {
  const bool has_them = label.size() > 1 && label.front() == '\'' && label.back() == '\'';
  return has_them ? trimmed(label.substr(1, label.size() - 2)) : label;
}

/// Checks that a label after a blank or a tab, without quotes, contains nothing else.
void requireOneLabel(const std::string& label, const std::string& where) {
  static const std::regex with_separator(R"((-|[-=:|/>~]+[ \t].*|.*[,;]))");
  static const std::regex with_comment(R"(.*[ \t](#|//)[ \t].*)");
  if (label.empty()) throw Error(where + " has no label; write " + kWanted + ".");
  if (label.find('\t') != std::string::npos) {
    throw Error(where + " has more than two columns; leave only " + kWanted + ".");
  }
  const std::string head = headOf(label);
  if (std::regex_match(head, with_separator) || std::regex_match(head, with_comment)) {
    throw Error(where + " may contain more than a label: '" + head + "'; write " + kWanted +
                " (put such a name in double quotes).");
  }
}

/// The time and the separator of a line; what follows them becomes the label as it stands. Throws
/// Error if the line does not begin with a timestamp.
RawLine splitOffTime(const std::string& line, const std::string& where) {
  // The timestamp, possibly quoted, and what separates it from the label. A comma followed by
  // digits may be a decimal comma, but only before a semicolon or a tab.
  static const std::regex with_decimal_comma(R"re([ \t]*("?)([+-]?\d+,\d+)\1 *([;\t]))re");
  static const std::regex usual(
      R"re([ \t]*("?)([+-]?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)\1(?:[ \t]*([,;])|[ \t]))re");
  const std::string head = headOf(line);
  std::smatch parts;
  const auto starts = [&head, &parts](const std::regex& pattern) {
    return std::regex_search(head, parts, pattern, std::regex_constants::match_continuous);
  };
  if (!starts(with_decimal_comma) && !starts(usual)) {
    throw Error(where + " is not " + kWanted + ".");
  }
  const char separator = parts[3].matched && parts[3] != "\t" ? *parts[3].first : ' ';
  std::string number = parts[2];
  std::replace(number.begin(), number.end(), ',', '.');
  RawLine raw{std::strtod(number.c_str(), nullptr), separator,
              trimmed(line.substr(static_cast<std::size_t>(parts.length())))};
  if (raw.time < 0) throw Error(where + " has a negative timestamp; count from 1970, in s.");
  return raw;
}

/// '1700000000,5 kitchen' has either a decimal comma or a room '5 kitchen'.
void requireNoDecimalComma(const RawLine& raw, const std::string& where) {
  static const std::regex digits_and_more(R"(\d+[ \t]+\S)");
  const std::string label = headOf(raw.label);
  if (raw.separator != ',' ||
      !std::regex_search(label, digits_and_more, std::regex_constants::match_continuous)) {
    return;
  }
  throw Error(where + " has either a decimal comma or the label '" + label +
              "'; write the timestamp with a point, or the label in double quotes.");
}

RawLine split(const std::string& line, const std::string& where) {
  RawLine raw = splitOffTime(line, where);
  const bool is_quoted = !raw.label.empty() && raw.label[0] == '"';
  if (raw.separator != ' ') {
    requireNoDecimalComma(raw, where);
    raw.label = onlyField(raw.label, raw.separator, where);
  } else if (is_quoted) {
    raw.label = onlyField(raw.label, '\t', where);
  } else {
    requireOneLabel(raw.label, where);
  }
  if (!is_quoted) {
    requireNoTime(raw.label, raw.time, where);
    raw.label = withoutSingleQuotes(raw.label);
  }
  return raw;
}

double secondsPerUnit(double time) {
  if (time > 1e17) return 1e-9;
  if (time > 1e14) return 1e-6;
  if (time > 1e11) return 1e-3;  // the year 5138 in seconds
  return 1;
}

std::string noteOn(char separator, double unit) {
  std::string note;
  if (separator == ',') note = "as columns separated by commas";
  if (separator == ';') note = "as columns separated by semicolons";
  const char* name = unit == 1e-9 ? "ns" : unit == 1e-6 ? "us" : "ms";
  if (unit != 1) note += std::string(note.empty() ? "" : ", ") + "with timestamps in " + name;
  return note.empty() ? "" : "is read " + note + ".";
}

}  // namespace

LabelLines readLabelLines(const std::string& path) {
  const std::string bytes = readFile(path, kMaxFileBytes);
  if (const FileKind* kind = foreignFile(bytes)) {
    throw Error(path + " is " + std::string(kind->name) + "; " + std::string(kind->remedy) + ".");
  }
  const std::vector<std::string> lines = linesOf(toUtf8(bytes));
  LabelLines read;
  char separator = 0;
  double unit = 1;
  bool may_be_header = true;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string line = withPlainBlanks(lines[i]);
    // Spreadsheet programs declare the separator with 'sep=;'.
    if (line.empty() || line[0] == '#' || startsWith(line, "sep=")) continue;
    const std::string where = path + ", line " + std::to_string(i + 1);
    if (std::exchange(may_be_header, false) && isHeader(line)) continue;
    const RawLine raw = split(line, where);
    if (read.lines.empty()) {
      separator = raw.separator;
      unit = secondsPerUnit(raw.time);
    }
    if (raw.separator != separator) {
      throw Error(where + " separates its columns differently from the lines before; write " +
                  kWanted + ".");
    }
    if (secondsPerUnit(raw.time) != unit) {
      throw Error(where +
                  " has its timestamp in another unit than the lines before; write all "
                  "timestamps in s.");
    }
    read.lines.push_back({raw.time * unit, raw.label, static_cast<int>(i + 1)});
  }
  read.note = noteOn(separator, unit);
  return read;
}

}  // namespace place_recognition
