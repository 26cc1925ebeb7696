#pragma once

#include <string>
#include <string_view>

namespace place_recognition {

/// A file under a name that no other process uses. The destructor removes it unless it was renamed.
class TemporaryFile {
 public:
  /// Creates it; its path is `start`, six random characters, and `end`. Errors are about `target`.
  /// Throws Error if the folder cannot be written to.
  TemporaryFile(const std::string& start, const std::string& end, const std::string& target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

  /// Writes the contents to the disk and permits what the umask permits. Throws Error.
  void write(std::string_view bytes);

  /// Moves it to `path`, replacing a file of that name. Throws Error.
  void rename(const std::string& path);

 private:
  std::string path_;
  std::string target_;
  int fd_;
  bool renamed_ = false;
};

/// Throws an Error about `target` with the reason in errno.
[[noreturn]] void throwCannotWrite(const std::string& target);

}  // namespace place_recognition
