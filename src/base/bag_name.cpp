#include "base/bag_name.h"

#include <filesystem>
#include <system_error>

#include "base/text.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

const std::string kEnding = ".bag";
const std::string kActive = ".active";

std::string withoutActive(const std::string& path) {
  return path.substr(0, path.size() - kActive.size());
}

bool isFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

bool isActiveBag(const std::string& path) { return endsWith(lowerCase(path), kEnding + kActive); }

bool hasBagName(const std::string& path) {
  return endsWith(lowerCase(path), kEnding) || isActiveBag(path);
}

std::string howToRepair(const std::string& path) {
  const std::string name = withoutActive(path);
  return "rosbag reindex " + path + ", and rename it to " + name + " (" + name +
         ".orig.active is its backup)";
}

std::string whyActive(const std::string& path) {
  return "it is being recorded, or was left behind by a killed recorder; in the latter case run: " +
         howToRepair(path);
}

std::string whyMisnamed(const std::string& path) {
  return path + " is complete but has the name of an active recording; run: mv " + path + " " +
         withoutActive(path);
}

std::string bagBeside(const std::string& path) {
  const std::string bag = hasBagName(path) ? path : path + kEnding;
  if (bag != path && isFile(bag)) return "give " + bag + ", which lies beside it";
  const std::string active = bag + kActive;
  return isFile(active) ? active + " lies beside it: " + whyActive(active) : "";
}

}  // namespace place_recognition
