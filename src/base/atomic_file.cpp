#include "base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Separates the name of a file from the part that mkstemp() makes up.
constexpr const char* kTemporary = ".tmp-";

/// Closes the descriptor, and removes the temporary file unless it was renamed.
struct TemporaryFile {
  std::vector<char> path;
  int fd = -1;
  bool renamed = false;

  explicit TemporaryFile(const std::string& target) {
    const std::string pattern = target + kTemporary + "XXXXXX";
    path.assign(pattern.c_str(), pattern.c_str() + pattern.size() + 1);
    fd = mkstemp(path.data());
  }
  ~TemporaryFile() {
    if (fd < 0) return;
    close(fd);
    if (!renamed) unlink(path.data());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

[[noreturn]] void throwCannotWrite(const std::string& path) {
  throw Error("Cannot write " + path + ": " + std::strerror(errno) +
              "; make room, or choose a writable folder.");
}

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void syncFolder(const std::filesystem::path& folder) {
  const int fd = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (fd < 0) return;
  fsync(fd);
  close(fd);
}

/// Writes directly to what must not be replaced by a file: a terminal, a pipe, /dev/null.
void writeInto(const std::string& path, std::string_view bytes) {
  const int fd = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const bool written = fd >= 0 && writeAll(fd, bytes);
  const int reason = errno;
  if (fd >= 0) close(fd);
  errno = reason;
  if (!written) throwCannotWrite(path);
}

/// Whether `path` names an open file, such as /dev/stdout.
bool isOpenFile(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder == "/dev" || folder == "/dev/fd" || startsWith(folder, "/proc/");
}

bool isSpecial(const std::string& path) {
  struct stat status;
  if (stat(path.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return false;
  return !S_ISREG(status.st_mode) || isOpenFile(path);
}

}  // namespace

std::string behindLinks(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMaxLinks = 40;  // the kernel's limit
  fs::path file = path;
  std::error_code failure;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(file, failure)); ++i) {
    file = file.parent_path() / fs::read_symlink(file, failure);
  }
  if (fs::is_symlink(fs::symlink_status(file, failure))) {
    throw Error("Cannot write " + path + ": its links lead in a circle; remove it.");
  }
  return file.string();
}

void writeFileAtomically(const std::string& given_path, std::string_view bytes,
                         const std::function<void()>& before_rename) {
  if (isSpecial(given_path)) {
    writeInto(given_path, bytes);
    return;
  }
  const std::string path = behindLinks(given_path);
  TemporaryFile file(path);
  const mode_t mask = umask(0);
  umask(mask);
  if (file.fd < 0 || fchmod(file.fd, 0666 & ~mask) != 0 || !writeAll(file.fd, bytes) ||
      fsync(file.fd) != 0) {
    throwCannotWrite(path);
  }
  if (before_rename) before_rename();
  if (std::rename(file.path.data(), path.c_str()) != 0) throwCannotWrite(path);
  file.renamed = true;
  syncFolder(std::filesystem::path(path).parent_path());
}

void removeLeftovers(const std::string& path) {
  namespace fs = std::filesystem;
  const std::string start = fs::path(path).filename().string() + kTemporary;
  const fs::path folder = fs::path(path).parent_path();
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, failure)) {
    const std::string name = entry.path().filename().string();
    if (startsWith(name, start)) fs::remove(entry.path(), failure);
  }
}

std::string readFile(const std::string& path, std::size_t limit) {
  // Otherwise opening a named pipe would wait for a writer.
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat status;
  if (fd < 0 || fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) {
    std::string why = fd < 0 ? std::strerror(errno) : "not a file";
    std::error_code ignored;
    if (fd < 0 && errno == ENOENT && std::filesystem::is_symlink(path, ignored)) {
      why = "it is a broken link";
    }
    if (fd >= 0) close(fd);
    throw Error("Cannot read " + path + ": " + why + "; check the name.");
  }
  std::string bytes;
  int failure = 0;
  if (static_cast<std::size_t>(status.st_size) <= limit) {
    bytes.resize(static_cast<std::size_t>(status.st_size));
    std::size_t got = 0;
    while (got < bytes.size()) {
      const ssize_t n = read(fd, &bytes[got], bytes.size() - got);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) failure = errno;
      if (n <= 0) break;
      got += static_cast<std::size_t>(n);
    }
    bytes.resize(got);
  }
  close(fd);
  if (failure != 0) throw Error("Cannot read " + path + ": " + std::strerror(failure) + ".");
  if (static_cast<std::size_t>(status.st_size) > limit) {
    throw Error(path + " has " + std::to_string(status.st_size) +
                " bytes, more than the maximum of " + std::to_string(limit) +
                "; it is probably the wrong file.");
  }
  return bytes;
}

}  // namespace place_recognition
