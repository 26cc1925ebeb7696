#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tool/progress_display.h"
#include "tool/verb.h"

namespace place_recognition::tool {

/// JSON with keys in alphabetical order.
using Json = nlohmann::json;

/// The outputs of a verb: text for a person, figures for a program, progress for both.
struct OutputOptions {
  std::string json;  ///< file, `-` for stdout; empty: no figures
  std::string progress = "auto";

  void addTo(Verb& verb);

  /// The stream for a person: stdout, or stderr if a program reads stdout.
  std::ostream& text() const;

  /// Writes the figures, one object on one line, if requested. Throws Error if the file cannot be
  /// written.
  void writeJson(const Json& figures) const;
};

/// Writes each warning as a line to stderr.
void printWarnings(const std::vector<std::string>& warnings);

/// One line of JSON; its strings may contain any bytes.
std::string jsonLine(const Json& value);

/// What a verb writes.
enum class Contents { kText, kBag, kModel };

/// Throws Error if no file can be created at `path`, or a file is there that does not begin like
/// one of these contents, for example an image whose name was meant as an input. This is reported
/// before the work instead of after it. Missing folders are allowed, and are not created.
void requireWritable(const std::string& path, Contents contents);

/// Writes a file like writeFileAtomically(), in a folder that is created if it is missing. Throws
/// Error also for a file that requireWritable() refuses.
void writeText(const std::string& path, std::string_view text);

/// Creates a folder, with those above it, unless it exists. The destructor removes those created
/// folders that are still empty.
class NewFolder {
 public:
  /// Throws Error if the folder cannot be created.
  explicit NewFolder(const std::string& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  // innermost first
};

}  // namespace place_recognition::tool
