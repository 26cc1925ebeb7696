#include "tool/output.h"

#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "base/atomic_file.h"
#include "place_recognition/error.h"

namespace place_recognition::tool {

void OutputOptions::addTo(Verb& verb) {
  verb.option("--json", "FILE", json, "Write the figures as JSON to FILE; - for stdout");
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

void requireWritable(const std::string& path) {
  namespace fs = std::filesystem;
  fs::path folder = fs::absolute(path).parent_path();
  std::error_code failure;
  if (fs::is_other(path, failure) || fs::is_character_file(path, failure)) return;  // /dev/null
  while (!fs::exists(folder, failure) && folder.has_relative_path()) folder = folder.parent_path();
  if (fs::is_directory(path, failure) || !fs::is_directory(folder, failure) ||
      access(folder.c_str(), W_OK | X_OK) != 0) {
    throw Error("Cannot write " + path + "; choose a folder that can be written.");
  }
}

void makeFolder(const std::string& path) {
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  if (failure) {
    throw Error("Cannot make the folder " + path + ": " + failure.message() +
                "; choose a folder that can be written.");
  }
}

}  // namespace place_recognition::tool
