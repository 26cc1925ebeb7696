#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace place_recognition {

/// A program that runs beside the test and is killed at the end. Its output is discarded.
class OtherProcess {
 public:
  explicit OtherProcess(const std::vector<std::string>& arguments) : pid_(fork()) {
    if (pid_ != 0) return;
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) {
      pointers.push_back(const_cast<char*>(argument.c_str()));
    }
    pointers.push_back(nullptr);
    if (!freopen("/dev/null", "w", stdout)) _exit(127);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  ~OtherProcess() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  OtherProcess(const OtherProcess&) = delete;
  OtherProcess& operator=(const OtherProcess&) = delete;

  /// Pauses the process: its connections stay open, but it does not read from them.
  void pause() const { kill(pid_, SIGSTOP); }

 private:
  pid_t pid_;
};

/// Returns the memory in use by the process that was started with `argument`; 0 if there is none.
inline std::size_t residentBytes(const std::string& argument) {
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    std::ifstream command(process.path() / "cmdline");
    const std::string arguments{std::istreambuf_iterator<char>(command), {}};
    if (arguments.find(argument + '\0') == std::string::npos) continue;
    std::size_t total = 0, resident = 0;
    std::ifstream(process.path() / "statm") >> total >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  }
  return 0;
}

}  // namespace place_recognition
