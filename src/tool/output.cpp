#include "tool/output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>

#include "base/atomic_file.h"
#include "base/file_kind.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"

namespace place_recognition::tool {

namespace fs = std::filesystem;

namespace {

/// Throws Error if the file at `path` would be lost by mistake. One that is empty or cannot be read
/// may be replaced.
void requireAlike(const std::string& path, Contents contents) {
  const std::string start = startOfFile(path);
  if (start.empty()) return;
  const char* name = "a text file";
  bool alike = start.find('\0') == std::string::npos;
  if (contents == Contents::kBag) {
    name = "a bag";
    alike = startsWith(start, "#ROSBAG");
  } else if (contents == Contents::kModel) {
    name = "a model";
    alike = startsAsModel(path);
  }
  if (!alike) {
    throw Error("Cannot write " + path + ": a file that is not " + name +
                " has this name; choose another name, or remove it.");
  }
}

}  // namespace

void OutputOptions::addTo(Verb& verb) {
  verb.option("--json", "FILE", json, "Write the results as JSON to FILE; - for stdout")
      .written()
      .checked([](const std::string& file) {
        if (!file.empty() && file != "-") requireWritable(file, Contents::kText);
      });
  verb.option("--progress", "STYLE", progress,
              "auto, bar, lines, json (lines {\"stage\", \"fraction\"} on stdout) or none")
      .oneOf({"auto", "bar", "lines", "json", "none"});
}

std::ostream& OutputOptions::text() const {
  return json == "-" || progress == "json" ? std::cerr : std::cout;
}

void OutputOptions::writeJson(const Json& figures) const {
  if (json.empty()) return;
  if (json == "-") {
    std::cout << jsonLine(figures) << std::flush;
  } else {
    writeText(json, jsonLine(figures));
  }
}

void printWarnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << "\n";
}

std::string jsonLine(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void requireWritable(const std::string& path, Contents contents) {
  std::error_code failure;
  if (fs::is_other(path, failure) || fs::is_character_file(path, failure)) return;  // /dev/null
  if (fs::is_directory(path, failure)) {
    throw Error("Cannot write " + path + ": it is a folder; name a file.");
  }
  fs::path folder = fs::absolute(behindLinks(path)).parent_path();
  while (!fs::exists(folder, failure) && folder.has_relative_path()) folder = folder.parent_path();
  std::string reason;
  if (!fs::is_directory(folder, failure)) {
    reason = folder.string() + " is not a folder";
  } else if (access(folder.c_str(), W_OK | X_OK) != 0) {
    reason = folder.string() + ": " + std::strerror(errno);
  }
  if (!reason.empty()) {
    throw Error("Cannot write " + path + " (" + reason + "); choose a writable folder.");
  }
  requireAlike(path, contents);
}

void writeText(const std::string& path, std::string_view text) {
  requireAlike(path, Contents::kText);
  const NewFolder folder(fs::absolute(behindLinks(path)).parent_path().string());
  writeFileAtomically(path, text);
}

NewFolder::NewFolder(const std::string& path) {
  std::error_code failure;
  for (fs::path folder = fs::absolute(path);
       !fs::exists(folder, failure) && folder.has_relative_path(); folder = folder.parent_path()) {
    made_.push_back(folder);
  }
  fs::create_directories(path, failure);
  if (failure) {
    throw Error("Cannot create the folder " + path + ": " + failure.message() +
                "; choose a writable folder.");
  }
}

NewFolder::~NewFolder() {
  std::error_code failure;
  for (const fs::path& folder : made_) {
    const bool holds_files = std::any_of(
        fs::recursive_directory_iterator(folder, failure), fs::recursive_directory_iterator(),
        [](const fs::directory_entry& entry) { return !entry.is_directory(); });
    if (!failure && !holds_files) fs::remove_all(folder, failure);
  }
}

}  // namespace place_recognition::tool
