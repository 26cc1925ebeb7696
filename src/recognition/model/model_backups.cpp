#include "recognition/model/model_backups.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "recognition/model/model_container.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// Holds a folder for one writer. No file is left behind, and the system lets go of it when its
/// holder dies. Where a file system knows no locks, nobody waits.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : fd_(open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    while (fd_ >= 0 && !held_) {
      held_ = flock(fd_, LOCK_EX) == 0;
      if (!held_ && errno != EINTR) break;
    }
  }
  ~FolderLock() {
    if (fd_ >= 0) close(fd_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool held() const { return held_; }

 private:
  int fd_;
  bool held_ = false;
};

/// Makes the file at `path` also its newest backup, and the backups one older. Renames and a hard
/// link: whenever this is cut off, `path` itself has not been touched, and each backup is whole.
/// Where it is its own newest backup already, because a writer was killed after this, there is
/// nothing to do. What fails here is not worth losing a training for.
void keepBackup(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored) || fs::equivalent(path, backupPath(path, 1), ignored)) return;
  for (int age = kModelBackups; age > 1; --age) {
    fs::rename(backupPath(path, age - 1), backupPath(path, age), ignored);
  }
  std::error_code no_link;
  fs::create_hard_link(behindLinks(path), backupPath(path, 1), no_link);
  if (!no_link) return;
  try {
    writeFileAtomically(backupPath(path, 1), readFile(path, kMaxModelBytes));
  } catch (const Error&) {
  }
}

}  // namespace

std::string backupPath(const std::string& path, int age) {
  return path + "." + std::to_string(age);
}

void replaceKeepingBackups(const std::string& path, std::string_view bytes) {
  const FolderLock lock(fs::path(path).parent_path());
  if (lock.held()) removeLeftovers(behindLinks(path));
  writeFileAtomically(path, bytes, [&path] { keepBackup(path); });
}

}  // namespace place_recognition
