#include "base/user_path.h"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// `user`: empty is the one who calls.
fs::path homeOf(const std::string& user) {
  const char* home = std::getenv("HOME");
  if (user.empty() && home != nullptr && *home != '\0') return home;
  const passwd* entry = user.empty() ? getpwuid(getuid()) : getpwnam(user.c_str());
  if (entry == nullptr) {
    throw Error("There is no user '" + user + "' whose home folder ~" + user +
                " could be; give the whole path.");
  }
  return entry->pw_dir;
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

std::string userPath(const std::string& path) {
  if (path.empty()) return path;
  if (path[0] == '/') return path;
  if (path[0] == '~') {
    const std::size_t slash = std::min(path.find('/'), path.size());
    return homeOf(path.substr(1, slash - 1)).string() + path.substr(slash);
  }
  return (folderOfCall() / (path.compare(0, 2, "./") == 0 ? path.substr(2) : path)).string();
}

}  // namespace place_recognition
