#include "tool/output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "base/atomic_file.h"
#include "place_recognition/error.h"
#include "recognition/model/model_container.h"

namespace place_recognition::tool {

namespace fs = std::filesystem;

namespace {

/// Throws Error if the file at `path` would be lost by mistake. One that is empty or cannot be read
/// may be replaced.
void requireAlike(const std::string& path, Contents contents) {
  std::ifstream file(path, std::ios::binary);
  std::string start(512, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (start.empty()) return;
  std::istringstream stream(start);
  const char* name = "a text file";
  bool alike = start.find('\0') == std::string::npos;
  if (contents == Contents::kBag) {
    name = "a bag";
    alike = start.rfind("#ROSBAG", 0) == 0;
  } else if (contents == Contents::kModel) {
    name = "a model";
    alike = startsAsContainer(stream);
  }
  if (!alike) {
    throw Error("Cannot write " + path + ": a file that is not " + name +
                " has this name; choose another name, or remove it.");
  }
}

}  // namespace

void OutputOptions::addTo(Verb& verb) {
  verb.option("--json", "FILE", json, "Write the results as JSON to FILE; - for stdout")
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
    writeFileAtomically(json, jsonLine(figures));
  }
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
