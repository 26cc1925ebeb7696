#include "base/keyboard.h"

#include <poll.h>
#include <unistd.h>

namespace place_recognition {
namespace {

constexpr int kPollPeriod = 100;  // ms; the thread notices its end within this time

}  // namespace

Keyboard::Keyboard(int terminal, Callback callback)
    : terminal_(terminal), callback_(std::move(callback)) {
  tcgetattr(terminal_, &before_);
  termios keys = before_;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  tcsetattr(terminal_, TCSANOW, &keys);
  thread_ = std::thread([this] { read(); });
}

Keyboard::~Keyboard() {
  ended_ = true;
  thread_.join();
  tcsetattr(terminal_, TCSANOW, &before_);
}

bool Keyboard::isUsable(int descriptor) {
  if (!isatty(descriptor)) return false;
  const pid_t foreground = tcgetpgrp(descriptor);  // -1: not the terminal of this session
  return foreground < 0 || foreground == getpgrp();
}

void Keyboard::read() {
  while (!ended_) {
    pollfd input{terminal_, POLLIN, 0};
    if (poll(&input, 1, kPollPeriod) <= 0) continue;
    char key = 0;
    if (::read(terminal_, &key, 1) != 1) return;  // the terminal has been closed
    callback_(key);
  }
}

}  // namespace place_recognition
