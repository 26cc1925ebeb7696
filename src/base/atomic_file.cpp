#include "base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/descriptor_io.h"
#include "base/temporary_file.h"
#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Separates the name of a file from the random part of its temporary one.
constexpr const char* kTemporary = ".tmp-";

void syncFolder(const std::filesystem::path& folder) {
  const int fd = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (fd < 0) return;
  fsync(fd);
  close(fd);
}

/// Writes directly to what must not be replaced by a file: a terminal, a pipe, /dev/null.
void writeInto(const std::string& path, std::string_view bytes) {
  const int fd = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const bool written = fd >= 0 && writeAll(fd, bytes.data(), bytes.size());
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
  TemporaryFile file(path + kTemporary, "", path);
  file.write(bytes);
  if (before_rename) before_rename();
  file.rename(path);
  syncFolder(std::filesystem::path(path).parent_path());
}

void removeLeftovers(const std::string& path) {
  std::error_code ignored;
  for (const auto& file : pathsStartingWith(path + kTemporary)) {
    std::filesystem::remove(file, ignored);
  }
}

std::vector<std::filesystem::path> pathsStartingWith(const std::filesystem::path& start) {
  namespace fs = std::filesystem;
  std::vector<fs::path> paths;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(fs::absolute(start).parent_path(), failure)) {
    const std::string name = entry.path().filename().string();
    if (startsWith(name, start.filename().string())) paths.push_back(entry.path());
  }
  return paths;
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
    const std::size_t got = readAll(fd, bytes.data(), bytes.size());
    failure = errno;
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
