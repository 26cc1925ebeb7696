#include "base/descriptor_io.h"

#include <unistd.h>

#include <cerrno>

namespace place_recognition {

bool writeAll(int fd, const void* bytes, std::size_t count) {
  const char* position = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = write(fd, position, count);
    if (written < 0 && errno != EINTR) return false;
    if (written <= 0) continue;
    position += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

std::size_t readAll(int fd, void* bytes, std::size_t count) {
  char* start = static_cast<char*>(bytes);
  std::size_t done = 0;
  errno = 0;
  while (done < count) {
    const ssize_t got = read(fd, start + done, count - done);
    if (got < 0 && errno == EINTR) {
      errno = 0;
      continue;
    }
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace place_recognition
