#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace place_recognition {

/// Opens /dev/null for each standard stream that is closed, so that no file or pipe gets its
/// number; to be called first in main(). Writing to these streams still fails.
void reserveStandardStreams();

/// A program that runs in a child process, with its standard output (and, on request, its standard
/// error) in pipes. It is started without a shell and inherits no other descriptor.
/// Requires open standard streams, see reserveStandardStreams(). Not thread-safe.
class ChildProcess {
 public:
  enum class Stderr { kDiscard, kPipe };

  /// Starts `arguments[0]`, a path. Throws Error if it cannot be started.
  ChildProcess(const std::vector<std::string>& arguments, Stderr stderr_use);
  /// Kills the program if it is still running.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  int output() const { return output_; }  ///< descriptor to read its standard output from

  using LineCallback = std::function<void(const std::string& line)>;
  /// Passes on the lines that have arrived on standard output and standard error; waits at most
  /// `timeout` for some. False: both have ended.
  bool readLines(std::chrono::milliseconds timeout, const LineCallback& on_output,
                 const LineCallback& on_error);

  /// Asks the program to stop (SIGINT), unless wait() has returned.
  void interrupt() const;
  /// Stops the program at once (SIGKILL), unless wait() has returned.
  void kill() const;
  /// Waits for the program to end and returns its status, as waitpid() does; again, if called
  /// again.
  int wait();

 private:
  pid_t pid_ = -1;  // -1: it has been waited for
  int status_ = 0;
  int output_ = -1;
  int errors_ = -1;          // -1: discarded
  std::string output_line_;  // start of a line that is still incomplete
  std::string error_line_;
};

/// "exit code 3" or "signal 11 (Segmentation fault)".
std::string describeExit(int status);

/// Throws Error if `program`, of this package, ended with a status that means that it could not be
/// started: exec failed, or a library is missing.
void requireStarted(const std::string& program, int status);

/// The path of an executable of this package. It is searched for in the folder that the environment
/// variable PLACE_RECOGNITION_LIBEXEC names, beside the running program, and in
/// lib/place_recognition of the same tree. Throws Error if it is in none of them.
std::string findExecutable(const std::string& name);

}  // namespace place_recognition
