#include "ros/confined_path.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPathBytes = 4096;

std::string home() {
  const char* folder = std::getenv("HOME");
  return folder == nullptr ? "" : folder;
}

bool liesBelow(const fs::path& path, const fs::path& root) {
  return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

/// `path` without links, if it is a bag below `root`.
std::optional<std::string> bagBelow(const fs::path& path, const std::string& root) {
  std::error_code failure;
  const fs::path folder = fs::canonical(root, failure);
  if (failure) return std::nullopt;
  const fs::path file = fs::canonical(folder / path, failure);  // `path` itself if it is absolute
  if (failure || !liesBelow(file, folder) || file.extension() != ".bag" ||
      !fs::is_regular_file(file, failure)) {
    return std::nullopt;
  }
  return file.string();
}

std::string shortened(const std::string& path) {
  std::string text = path.substr(0, 200);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

}  // namespace

std::string confinedBagPath(const std::string& path, const std::vector<std::string>& roots) {
  const bool readable =
      !path.empty() && path.size() <= kMaxPathBytes && path.find('\0') == std::string::npos;
  if (readable) {
    const fs::path expanded = path.compare(0, 2, "~/") == 0 ? home() + path.substr(1) : path;
    for (const std::string& root : roots) {
      if (const auto bag = bagBelow(expanded, root)) return *bag;
    }
  }
  std::string folders;
  for (const std::string& root : roots) folders += (folders.empty() ? "" : ", ") + root;
  throw Error("'" + shortened(path) + "' is no bag (*.bag) below " + folders +
              "; move it there, or set ~bag_roots.");
}

std::vector<std::string> defaultBagRoots() {
  std::vector<std::string> roots;
  if (!home().empty()) roots.push_back(home());
  if (const char* ros_home = std::getenv("ROS_HOME")) roots.emplace_back(ros_home);
  return roots;
}

}  // namespace place_recognition
