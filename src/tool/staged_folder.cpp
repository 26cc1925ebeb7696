#include "tool/staged_folder.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "base/atomic_file.h"
#include "place_recognition/error.h"

namespace place_recognition::tool {

namespace fs = std::filesystem;

namespace {

/// Hidden, so that nobody takes it for a complete folder.
std::string temporaryStart(const fs::path& target) {
  return (target.parent_path() / ("." + target.filename().string() + ".tmp-")).string();
}

/// Removes the temporary folders of killed processes.
void removeUnfinished(const fs::path& target) {
  const std::string start = temporaryStart(target);
  const std::size_t pid_at = fs::path(start).filename().string().size();
  std::error_code ignored;
  for (const fs::path& folder : pathsStartingWith(start)) {
    const int owner = std::atoi(folder.filename().c_str() + pid_at);
    if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH) fs::remove_all(folder, ignored);
  }
}

}  // namespace

StagedFolder::StagedFolder(const std::string& target) : target_(target) {
  if (fs::exists(target_) && !(fs::is_directory(target_) && fs::is_empty(target_))) {
    throw Error(target + " already exists; remove it or choose another folder.");
  }
  removeUnfinished(target_);
  path_ = temporaryStart(target_) + std::to_string(getpid());
  std::error_code failure;
  if (!fs::create_directory(path_, failure)) {
    throw Error("Cannot write " + target + "; choose a writable folder.");
  }
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void StagedFolder::commit() {
  fs::rename(path_, target_);
  path_.clear();
}

}  // namespace place_recognition::tool
