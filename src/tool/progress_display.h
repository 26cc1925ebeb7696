#pragma once

#include <chrono>
#include <string>

#include "place_recognition/progress.h"

namespace place_recognition::tool {

/// Shows the progress of a verb, and stops the verb when a signal requests it.
///
/// bar    one line on stderr, redrawn: stage, bar, percentage, time left
/// lines  one line on stderr every few seconds, starting after one second
/// json   lines {"stage": ..., "fraction": ...} on stdout, for other programs
/// none   nothing
/// auto   bar if stderr is a terminal, else lines
class ProgressDisplay {
 public:
  /// `style`: one of the above.
  explicit ProgressDisplay(const std::string& style);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// The callback for the work; this display must outlive it.
  Progress callback();

  /// Removes the bar before something else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  enum class Style { kBar, kLines, kJson, kNone };

  bool show(const std::string& stage, double fraction);
  void print(double fraction) const;
  std::string timeLeft(double fraction) const;

  Style style_;
  std::string stage_;
  Clock::time_point stage_start_;
  Clock::time_point next_print_ = Clock::now();
  bool bar_drawn_ = false;
};

}  // namespace place_recognition::tool
