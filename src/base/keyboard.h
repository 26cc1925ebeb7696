#pragma once

#include <termios.h>

#include <atomic>
#include <functional>
#include <thread>

namespace place_recognition {

/// Reads the keys pressed in a terminal, without waiting for the end of a line, in its own thread.
/// Ctrl-C keeps its function. After Ctrl-Z, keys are read again as soon as the program is in the
/// foreground.
class Keyboard {
 public:
  using Callback = std::function<void(char key)>;

  /// `terminal`: a descriptor that isUsable().
  Keyboard(int terminal, Callback callback);
  /// Restores the terminal, unless the program is in the background.
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Whether `descriptor` is a terminal whose keys are meant for this program. A program in the
  /// background would be stopped for touching it.
  static bool isUsable(int descriptor);

 private:
  /// Lets keys arrive at once. A shell sets the line mode again when it continues the program.
  void endLineMode();
  void read();

  int terminal_;
  Callback callback_;
  termios before_{};  // the mode to restore
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace place_recognition
