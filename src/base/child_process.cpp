#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr int kNotStarted = 127;  // as shells and the dynamic loader say it

/// Both ends of a pipe, closed by the destructor unless taken.
struct Pipe {
  int read_end = -1;
  int write_end = -1;

  Pipe() {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw Error(std::string("Cannot start another process: ") + std::strerror(errno) + ".");
    }
    read_end = ends[0];
    write_end = ends[1];
  }
  ~Pipe() {
    if (read_end >= 0) close(read_end);
    if (write_end >= 0) close(write_end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int takeReadEnd() { return std::exchange(read_end, -1); }
};

/// Runs between fork and exec, so it must be safe after the fork of a program with threads.
void closeOtherDescriptors() {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, 0) == 0) return;
#endif
  const long limit = std::min(sysconf(_SC_OPEN_MAX), 65536L);
  for (int fd = STDERR_FILENO + 1; fd < limit; ++fd) close(fd);
}

[[noreturn]] void becomeProgram(char* const* arguments, int input, int output, int errors) {
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  closeOtherDescriptors();
  // A handler or mask of this program must not prevent the child from being stopped.
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM}) signal(number, SIG_DFL);
  execv(arguments[0], arguments);
  _exit(kNotStarted);
}

constexpr std::size_t kMaxLine = 1 << 20;

/// Reads once and passes on complete lines; a line that is too long is split. False at the end,
/// after passing on the rest.
bool readSome(int fd, std::string& line, const ChildProcess::LineCallback& on_line) {
  std::array<char, 4096> buffer;
  const ssize_t count = read(fd, buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return true;
  for (ssize_t i = 0; i < count; ++i) {
    const char c = buffer[static_cast<std::size_t>(i)];
    if (c != '\n') line += c;
    if (c == '\n' || line.size() == kMaxLine) {
      on_line(line);
      line.clear();
    }
  }
  if (count > 0) return true;
  if (!line.empty()) on_line(line);
  line.clear();
  return false;
}

void closeOnce(int& fd) {
  if (fd >= 0) close(fd);
  fd = -1;
}

}  // namespace

void reserveStandardStreams() {
  int fd = 0;
  while (fd >= 0 && fd <= STDERR_FILENO) fd = open("/dev/null", O_RDONLY);
  if (fd >= 0) close(fd);
}

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, Stderr stderr_use) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));  // exec does not modify them
  }
  pointers.push_back(nullptr);
  Pipe output;
  Pipe errors;
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  const int child_errors = stderr_use == Stderr::kPipe ? errors.write_end : null;
  pid_ = fork();
  if (pid_ == 0) becomeProgram(pointers.data(), null, output.write_end, child_errors);
  close(null);
  if (pid_ < 0) {
    throw Error("Cannot start " + arguments[0] + ": " + std::strerror(errno) + ".");
  }
  output_ = output.takeReadEnd();
  if (stderr_use == Stderr::kPipe) errors_ = errors.takeReadEnd();
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill();
    wait();
  }
  closeOnce(output_);
  closeOnce(errors_);
}

bool ChildProcess::readLines(std::chrono::milliseconds timeout, const LineCallback& on_output,
                             const LineCallback& on_error) {
  // poll() ignores descriptors that are -1.
  std::array<pollfd, 2> pipes{{{output_, POLLIN, 0}, {errors_, POLLIN, 0}}};
  if (output_ < 0 && errors_ < 0) return false;
  if (poll(pipes.data(), pipes.size(), static_cast<int>(timeout.count())) <= 0) return true;
  if (pipes[0].revents != 0 && !readSome(output_, output_line_, on_output)) closeOnce(output_);
  if (pipes[1].revents != 0 && !readSome(errors_, error_line_, on_error)) closeOnce(errors_);
  return true;
}

void ChildProcess::interrupt() const {
  if (pid_ > 0) ::kill(pid_, SIGINT);
}

void ChildProcess::kill() const {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

int ChildProcess::wait() {
  if (pid_ > 0) {
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
  }
  pid_ = -1;
  return status_;
}

std::string describeExit(int status) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
  }
  return "exit code " + std::to_string(WEXITSTATUS(status));
}

void requireStarted(const std::string& program, int status) {
  if (!WIFEXITED(status) || WEXITSTATUS(status) != kNotStarted) return;
  throw Error("The program " + program +
              " of place_recognition cannot be started; build or install the whole package again.");
}

std::string findExecutable(const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path own_folder = fs::read_symlink("/proc/self/exe").parent_path();
  std::vector<fs::path> folders{own_folder, own_folder / "../lib/place_recognition"};
  if (const char* folder = std::getenv("PLACE_RECOGNITION_LIBEXEC")) {
    folders.insert(folders.begin(), folder);
  }
  for (const fs::path& folder : folders) {
    if (access((folder / name).c_str(), X_OK) == 0) return (folder / name).string();
  }
  throw Error("The program " + name + " of place_recognition is not in " + own_folder.string() +
              "; build or install the whole package, or set "
              "PLACE_RECOGNITION_LIBEXEC to its folder.");
}

}  // namespace place_recognition
