#include "base/confined_path.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>

#include "base/atomic_file.h"
#include "base/bag_name.h"
#include "base/contains.h"
#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShown = 200;  // bytes of a path in a message
constexpr std::size_t kMaxPathBytes = 4096;

std::string home() {
  const char* folder = std::getenv("HOME");
  return folder == nullptr ? "" : folder;
}

/// `path` with "~/" at its start replaced by the home folder, as in a shell.
std::string withHome(const std::string& path) {
  for (const std::string start : {"~/", "$HOME/", "${HOME}/"}) {
    if (startsWith(path, start)) return home() + path.substr(start.size() - 1);
  }
  return path;
}

bool liesBelowAny(const fs::path& path, const std::vector<std::string>& roots) {
  return std::any_of(roots.begin(), roots.end(), [&path](const std::string& root) {
    std::error_code failure;
    const fs::path folder = fs::canonical(root, failure);
    return !failure && liesIn(path, folder);
  });
}

/// `path` without links if it is a bag below any root; a relative path starts at `root`.
std::optional<std::string> bagBelow(const fs::path& path, const std::string& root,
                                    const std::vector<std::string>& roots) {
  std::error_code failure;
  const fs::path file = fs::canonical(root / path, failure);  // an absolute `path` ignores `root`
  if (failure || !liesBelowAny(file, roots) || file.extension() != ".bag" ||
      !fs::is_regular_file(file, failure)) {
    return std::nullopt;
  }
  return file.string();
}

/// Why what exists at `path`, below a root, is not a bag; empty if nothing exists.
std::string whyNoBag(const fs::path& path, const std::string& root,
                     const std::vector<std::string>& roots) {
  std::error_code failure;
  const fs::path file = fs::canonical(root / path, failure);
  if (failure || !liesBelowAny(file, roots)) return "";
  if (fs::is_directory(file, failure)) return "is a folder; name the bags in it, such as run.bag";
  if (!fs::is_regular_file(file, failure)) return "is a pipe or a device, not a bag; name a file";
  return "does not end in .bag; give the bag a name that does";
}

/// A link below a root that leads out of all roots.
struct WayOut {
  fs::path link;
  fs::path target;
  fs::path folder;  // the folder that would have to be a root
};

/// Final target of a link, whether it exists or not.
fs::path targetOf(const fs::path& link) {
  std::error_code failure;
  return fs::weakly_canonical(behindLinks(link.string()), failure);
}

/// The first link on the path from `root` along `path` that leads out. What lies behind it is not
/// examined.
std::optional<WayOut> wayOut(const fs::path& path, const std::string& root,
                             const std::vector<std::string>& roots) {
  const fs::path below = path.is_absolute() ? path.lexically_relative(root) : path;
  if (below.empty() || contains(below, "..")) return std::nullopt;
  fs::path current = root;
  for (auto part = below.begin(); part != below.end(); ++part) {
    current /= *part;
    std::error_code failure;
    if (!fs::is_symlink(fs::symlink_status(current, failure))) continue;
    const fs::path target = targetOf(current);
    if (target.empty() || liesBelowAny(target, roots)) continue;
    const bool is_last = std::next(part) == below.end();
    return WayOut{current, target, is_last ? target.parent_path() : target};
  }
  return std::nullopt;
}

/// Why there is no file at `path`, below a root, and what to do; empty unless that is so.
std::string whyMissing(const fs::path& path, const std::vector<std::string>& roots) {
  std::string why;
  for (const std::string& root : roots) {
    std::error_code failure;
    const fs::path file = fs::weakly_canonical(root / path, failure);
    if (failure || !liesBelowAny(file, roots)) continue;
    if (fs::status(file, failure).type() != fs::file_type::not_found) continue;
    if (fs::is_symlink(fs::symlink_status(file, failure))) {
      const fs::path target = targetOf(file);
      if (!liesBelowAny(target, roots)) continue;
      return "is a broken link; check " + target.string();
    }
    const std::string meant = bagBeside(file.string());
    if (!meant.empty()) return "does not exist; " + meant;
    why = "does not exist below " + listed(roots) + "; check the path";
  }
  return why;
}

}  // namespace

bool liesIn(const fs::path& path, const fs::path& folder) {
  return !folder.empty() &&
         std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
             folder.end();
}

std::string confinedBagPath(const std::string& path, const std::vector<std::string>& roots) {
  const bool readable =
      !path.empty() && path.size() <= kMaxPathBytes && path.find('\0') == std::string::npos;
  if (readable) {
    const fs::path expanded = withHome(path);
    for (const std::string& root : roots) {
      if (const auto bag = bagBelow(expanded, root, roots)) return *bag;
    }
    for (const std::string& root : roots) {
      const std::string why_not = whyNoBag(expanded, root, roots);
      if (!why_not.empty()) throw Error(inQuotes(path, kShown) + " " + why_not + ".");
    }
    for (const std::string& root : roots) {
      if (const auto way_out = wayOut(expanded, root, roots)) {
        throw Error(inQuotes(path, kShown) + " is reached through the link " +
                    way_out->link.string() + ", which leads to " + way_out->target.string() +
                    ", outside of the permitted folders; add " + way_out->folder.string() +
                    " to ~bag_roots.");
      }
    }
    const std::string missing = whyMissing(expanded, roots);
    if (!missing.empty()) throw Error(inQuotes(path, kShown) + " " + missing + ".");
  }
  throw Error(inQuotes(path, kShown) + " is not a bag (*.bag) below " + listed(roots) +
              "; move it there, or set ~bag_roots.");
}

std::vector<std::string> defaultBagRoots() {
  std::vector<std::string> roots;
  if (!home().empty()) roots.push_back(home());
  if (const char* ros_home = std::getenv("ROS_HOME")) roots.emplace_back(ros_home);
  return roots;
}

}  // namespace place_recognition
