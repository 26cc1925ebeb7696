#include "ros/bags/bag_guard.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include "base/process_limits.h"
#include "ros/bags/bag_records.h"

namespace place_recognition {
namespace {

constexpr int kMaxDescriptor = 64;
constexpr int kMaxSeconds = 60;

struct stat bag_file;

void onCrash(int number) {
  writeCrash(STDOUT_FILENO, bagOffset());
  signal(number, SIG_DFL);
  raise(number);
}

}  // namespace

void guardBag(const std::string& path) {
  stat(path.c_str(), &bag_file);
  limitMemory();
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGPROF}) signal(number, onCrash);
  restartWorkLimit();
}

void restartWorkLimit() {
  const itimerval limit{{0, 0}, {kMaxSeconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

std::uint64_t bagOffset() {
  for (int fd = STDERR_FILENO + 1; fd < kMaxDescriptor; ++fd) {
    struct stat file;
    if (fstat(fd, &file) != 0) continue;
    if (file.st_ino != bag_file.st_ino || file.st_dev != bag_file.st_dev) continue;
    const off_t offset = lseek(fd, 0, SEEK_CUR);
    if (offset > 0) return static_cast<std::uint64_t>(offset);
  }
  return 0;
}

}  // namespace place_recognition
