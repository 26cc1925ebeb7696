#include "base/temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/descriptor_io.h"
#include "place_recognition/error.h"

namespace place_recognition {

TemporaryFile::TemporaryFile(const std::string& start, const std::string& end,
                             const std::string& target)
    : path_(start + "XXXXXX" + end),
      target_(target),
      fd_(mkostemps(path_.data(), static_cast<int>(end.size()), O_CLOEXEC)) {
  if (fd_ < 0) throwCannotWrite(target_);
}

TemporaryFile::~TemporaryFile() {
  close(fd_);
  if (!renamed_) unlink(path_.c_str());
}

void TemporaryFile::write(std::string_view bytes) {
  const mode_t mask = umask(0);
  umask(mask);
  if (fchmod(fd_, 0666 & ~mask) != 0 || !writeAll(fd_, bytes.data(), bytes.size()) ||
      fsync(fd_) != 0) {
    throwCannotWrite(target_);
  }
}

void TemporaryFile::rename(const std::string& path) {
  if (std::rename(path_.c_str(), path.c_str()) != 0) throwCannotWrite(target_);
  renamed_ = true;
}

void throwCannotWrite(const std::string& target) {
  throw Error("Cannot write " + target + ": " + std::strerror(errno) +
              "; make room, or choose a writable folder.");
}

}  // namespace place_recognition
