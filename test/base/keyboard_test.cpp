// A terminal from which single keys are read.

#include "base/keyboard.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "eventually.h"

namespace place_recognition {
namespace {

/// A terminal with a person in front of it.
class PseudoTerminal {
 public:
  PseudoTerminal() : person_(posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(grantpt(person_) | unlockpt(person_), 0);
    name_ = ptsname(person_);
    program_ = open(name_.c_str(), O_RDWR | O_NOCTTY);
    EXPECT_GE(program_, 0);
  }
  ~PseudoTerminal() {
    close(program_);
    close(person_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Of the side of the program.
  int descriptor() const { return program_; }

  termios mode() const {
    termios mode{};
    EXPECT_EQ(tcgetattr(program_, &mode), 0);
    return mode;
  }
  void setMode(const termios& mode) const { EXPECT_EQ(tcsetattr(program_, TCSANOW, &mode), 0); }

  void type(const std::string& keys) const {
    EXPECT_EQ(write(person_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }

  /// Begins a session of this process, as a shell does.
  void logIn() const {
    setsid();
    close(open(name_.c_str(), O_RDWR));  // becomes the terminal of the session
  }

 private:
  int person_;
  int program_ = -1;
  std::string name_;
};

bool isInLineMode(const PseudoTerminal& terminal) {
  return (terminal.mode().c_lflag & (ICANON | ECHO)) != 0;
}

TEST(Keyboard, HandsOverEachKeyAtOnceAndLeavesTheTerminalAsItWas) {
  const PseudoTerminal terminal;
  ASSERT_TRUE(Keyboard::isUsable(terminal.descriptor()));
  const termios before = terminal.mode();
  termios during{};
  std::atomic<char> last{0};
  {
    const Keyboard keyboard(terminal.descriptor(), [&last](char key) { last = key; });
    during = terminal.mode();
    for (const char key : {'1', '2', '0'}) {
      terminal.type({key});
      EXPECT_TRUE(eventually([&] { return last == key; })) << key;
    }
  }
  EXPECT_FALSE(during.c_lflag & ICANON);
  EXPECT_TRUE(during.c_lflag & ISIG);  // Ctrl-C
  EXPECT_EQ(terminal.mode().c_lflag, before.c_lflag);
}

TEST(Keyboard, HandsOverKeysAfterAShellHasSetItsOwnMode) {
  const PseudoTerminal terminal;
  const termios before = terminal.mode();
  std::atomic<char> last{0};
  {
    const Keyboard keyboard(terminal.descriptor(), [&last](char key) { last = key; });
    terminal.setMode(before);  // as after Ctrl-Z and `fg`
    EXPECT_TRUE(eventually([&] { return !isInLineMode(terminal); }));
    terminal.type("1");
    EXPECT_TRUE(eventually([&] { return last == '1'; }));
  }
  EXPECT_EQ(terminal.mode().c_lflag, before.c_lflag);
}

/// Moves a program with a Keyboard to the background and types in its terminal. Returns whether the
/// program ends by itself, without having been stopped, and leaves the mode alone.
bool programInTheBackgroundEnds(const PseudoTerminal& terminal) {
  terminal.logIn();
  const termios before = terminal.mode();
  int moved[2];
  if (pipe(moved) != 0) return false;
  const pid_t program = fork();
  if (program == 0) {
    {
      const Keyboard keyboard(terminal.descriptor(), [](char) {});
      setpgid(0, 0);  // a group that is not the one in the foreground
      close(moved[0]);
      close(moved[1]);
      std::this_thread::sleep_for(std::chrono::milliseconds(400));
    }
    _exit(0);
  }
  close(moved[1]);
  char none = 0;
  if (read(moved[0], &none, 1) != 0) return false;  // until it has moved
  terminal.setMode(before);
  terminal.type("ls\n");
  int status = 0;
  waitpid(program, &status, WUNTRACED);
  if (WIFSTOPPED(status)) kill(program, SIGKILL);
  return WIFEXITED(status) && terminal.mode().c_lflag == before.c_lflag;
}

TEST(Keyboard, LeavesTheTerminalToTheForeground) {
  const PseudoTerminal terminal;
  const pid_t shell = fork();
  if (shell == 0) _exit(programInTheBackgroundEnds(terminal) ? 0 : 1);
  int status = 0;
  waitpid(shell, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST(Keyboard, NeedsATerminal) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(Keyboard::isUsable(ends[0]));
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace place_recognition
