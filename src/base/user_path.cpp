#include "base/user_path.h"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// An empty `user` means the caller.
fs::path homeOf(const std::string& user) {
  const char* home = std::getenv("HOME");
  if (user.empty() && home != nullptr && *home != '\0') return home;
  const passwd* entry = user.empty() ? getpwuid(getuid()) : getpwnam(user.c_str());
  if (entry == nullptr) {
    throw Error("There is no user '" + user + "', so ~" + user +
                " is not a home folder; give the full path.");
  }
  return entry->pw_dir;
}

/// `path`, which starts with '$', with the variable replaced by its value.
std::string withVariable(const std::string& path) {
  static const std::regex start(R"(\$(\w+|\{\w+\})(?=/|$))");
  std::smatch found;
  const std::string head = path.substr(0, 200);
  if (!std::regex_search(head, found, start, std::regex_constants::match_continuous)) return path;
  std::string name = found[1];
  if (name[0] == '{') name = name.substr(1, name.size() - 2);
  const char* value = std::getenv(name.c_str());
  if (value == nullptr || *value == '\0') {
    throw Error("The environment variable " + name + " in the path " + path +
                " is not set; set it or give the full path.");
  }
  return value + path.substr(static_cast<std::size_t>(found.length()));
}

bool isRoslaunch(const fs::path& process) {
  std::ifstream file(process / "cmdline");
  const std::string command{std::istreambuf_iterator<char>(file), {}};
  return command.find("roslaunch") != std::string::npos ||
         command.find("rostest") != std::string::npos;
}

fs::path folderOfCall() {
  const fs::path parent = "/proc/" + std::to_string(getppid());
  std::error_code failure;
  if (isRoslaunch(parent)) {
    const fs::path folder = fs::read_symlink(parent / "cwd", failure);
    if (!failure) return folder;
  }
  return fs::current_path();
}

}  // namespace

std::string userPath(const std::string& given) {
  if (given.empty()) return given;
  if (startsWith(given, "file:///")) return given.substr(7);
  const std::string path = given[0] == '$' ? withVariable(given) : given;
  if (path[0] == '/') return path;
  if (path[0] == '~') {
    const std::size_t slash = std::min(path.find('/'), path.size());
    return homeOf(path.substr(1, slash - 1)).string() + path.substr(slash);
  }
  return (folderOfCall() / (startsWith(path, "./") ? path.substr(2) : path)).string();
}

}  // namespace place_recognition
