#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tool/command_line.h"
#include "tool/progress_display.h"

namespace place_recognition::tool {

/// JSON, with its keys in alphabetical order.
using Json = nlohmann::json;

/// Where a verb's answers go: text for a person, figures for a program, progress for both.
struct OutputOptions {
  std::string json;  ///< file, `-` for stdout, empty for no figures
  std::string progress = "auto";

  void addTo(Verb& verb);

  /// For a person: stdout, or stderr where stdout belongs to a program.
  std::ostream& text() const;

  /// Writes the figures, one object on one line, if they were asked for. Throws Error if the file
  /// cannot be written.
  void writeJson(const Json& figures) const;
};

/// One line of JSON, whatever bytes its strings hold.
std::string jsonLine(const Json& value);

/// Throws Error if no file can be made at `path`, so that this is known before the work and not
/// after it. Missing folders are no hindrance, and are not made.
void requireWritable(const std::string& path);

/// A folder that is made, with those above it, unless it is there. In the end those that were made
/// and that nothing was put into are removed.
class NewFolder {
 public:
  /// Throws Error if it cannot be made.
  explicit NewFolder(const std::string& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  // the inner ones first
};

}  // namespace place_recognition::tool
