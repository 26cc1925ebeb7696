#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// From `time` on, s, the label is `label`; empty means none.
struct LabelLine {
  double time = 0;
  std::string label;
  int number = 0;  ///< of the line, from 1
};

struct LabelLines {
  std::vector<LabelLine> lines;
  std::string note;  ///< for a person: how the file was read if it deviates from the format
};

/// Reads a text file with lines `timestamp label` in order of time, such as COLD's labels.dat. The
/// separator is blanks, a tab, a comma or a semicolon, the same one throughout; the label may be in
/// double quotes (RFC 4180). If the separator is a semicolon or a tab, the timestamp may have a
/// decimal comma. Timestamps are in s, ms, us or ns since 1970, all in the same unit, which is
/// recognized by their size. Empty lines, lines that start with '#', and column headings in the
/// first line are skipped. The text is UTF-8 or UTF-16 (see toUtf8()). An ambiguous label, such as
/// '1005 kitchen' after the timestamp 1000, which may end there, must be in quotes. Throws Error
/// naming the faulty line.
LabelLines readLabelLines(const std::string& path);

}  // namespace place_recognition
