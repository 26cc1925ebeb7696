#pragma once

#include <termios.h>

#include <atomic>
#include <functional>
#include <thread>

namespace place_recognition {

/// Reads the keys pressed in a terminal, without waiting for the end of a line, in its own thread.
/// Ctrl-C keeps its function.
class Keyboard {
 public:
  using Callback = std::function<void(char key)>;

  /// `terminal`: a descriptor that isUsable().
  Keyboard(int terminal, Callback callback);
  /// Restores the terminal.
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Whether `descriptor` is a terminal whose keys are meant for this program. A program in the
  /// background would be stopped for touching it.
  static bool isUsable(int descriptor);

 private:
  void read();

  int terminal_;
  Callback callback_;
  termios before_{};
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace place_recognition
