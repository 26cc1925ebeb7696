#include "base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace place_recognition {

FolderLock::FolderLock(const std::string& folder, IfTaken if_taken)
    : fd_(open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  const int operation = LOCK_EX | (if_taken == IfTaken::kGiveUp ? LOCK_NB : 0);
  while (fd_ >= 0 && !held_) {
    held_ = flock(fd_, operation) == 0;
    if (!held_ && errno != EINTR) {
      taken_ = errno == EWOULDBLOCK;
      break;
    }
  }
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) close(fd_);
}

}  // namespace place_recognition
