#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// From `time` on, s, the label is `label`; empty: none.
struct LabelLine {
  double time = 0;
  std::string label;
  int number = 0;  ///< of the line, from 1
};

struct LabelLines {
  std::vector<LabelLine> lines;
  std::string note;  ///< how the file was read, for a person, if not as it should be written
};

/// Reads a text file of lines `timestamp label` in order of time, as in COLD's labels.dat. Blanks,
/// a tab, a comma or a semicolon stand between the two, the same one throughout; the label may
/// stand in double quotes (RFC 4180). Before a semicolon or a tab the timestamp may have a decimal
/// comma. Timestamps are in s, ms, us or ns since 1970, all in the same, told apart by their size.
/// Lines that are empty or start with '#', and a first line that heads the columns, are passed
/// over. The text is UTF-8, or UTF-16 (see toUtf8()). A label that could be more than one, as
/// '1005 kitchen' behind the timestamp 1000, which may end there, must stand in quotes. Throws
/// Error naming the line at fault.
LabelLines readLabelLines(const std::string& path);

}  // namespace place_recognition
