#include "base/keyboard.h"

#include <poll.h>
#include <unistd.h>

namespace place_recognition {
namespace {

constexpr int kPollPeriod = 100;  // ms; the thread notices its end within this time
constexpr tcflag_t kLineMode = ICANON | ECHO;

}  // namespace

Keyboard::Keyboard(int terminal, Callback callback)
    : terminal_(terminal), callback_(std::move(callback)) {
  tcgetattr(terminal_, &before_);
  endLineMode();
  thread_ = std::thread([this] { read(); });
}

Keyboard::~Keyboard() {
  ended_ = true;
  thread_.join();
  if (isUsable(terminal_)) tcsetattr(terminal_, TCSANOW, &before_);
}

bool Keyboard::isUsable(int descriptor) {
  if (!isatty(descriptor)) return false;
  const pid_t foreground = tcgetpgrp(descriptor);  // -1: not the terminal of this session
  return foreground < 0 || foreground == getpgrp();
}

void Keyboard::endLineMode() {
  termios mode{};
  if (tcgetattr(terminal_, &mode) != 0 || (mode.c_lflag & kLineMode) == 0) return;
  before_ = mode;
  mode.c_lflag &= ~kLineMode;
  tcsetattr(terminal_, TCSANOW, &mode);
}

void Keyboard::read() {
  while (!ended_) {
    const bool usable = isUsable(terminal_);
    if (usable) endLineMode();
    pollfd input{usable ? terminal_ : -1, POLLIN, 0};  // -1: only waits
    if (poll(&input, 1, kPollPeriod) <= 0 || !isUsable(terminal_)) continue;
    char key = 0;
    if (::read(terminal_, &key, 1) != 1) return;  // the terminal has been closed
    callback_(key);
  }
}

}  // namespace place_recognition
