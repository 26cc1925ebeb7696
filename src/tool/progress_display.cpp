#include "tool/progress_display.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>

#include "tool/output.h"
#include "tool/signals.h"

namespace place_recognition::tool {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

constexpr int kBarWidth = 24;
constexpr milliseconds kBarInterval{100};
constexpr milliseconds kLineInterval{3000};
constexpr milliseconds kQuietStart{1000};  // for lines: quick work needs none
constexpr milliseconds kJsonInterval{200};

int wholePercent(double fraction) { return static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0)); }

}  // namespace

ProgressDisplay::ProgressDisplay(const std::string& style) {
  static const std::map<std::string, Style> kStyles = {
      {"auto", isatty(STDERR_FILENO) ? Style::kBar : Style::kLines},
      {"bar", Style::kBar},
      {"lines", Style::kLines},
      {"json", Style::kJson},
      {"none", Style::kNone}};
  style_ = kStyles.at(style);
  if (style_ == Style::kLines) next_print_ += kQuietStart;
}

ProgressDisplay::~ProgressDisplay() { clear(); }

Progress ProgressDisplay::callback() {
  return [this](const std::string& stage, double fraction) { return show(stage, fraction); };
}

void ProgressDisplay::clear() {
  if (bar_drawn_) std::cerr << "\r\033[K" << std::flush;
  bar_drawn_ = false;
}

bool ProgressDisplay::show(const std::string& stage, double fraction) {
  const Clock::time_point now = Clock::now();
  const bool new_stage = stage != stage_;
  if (new_stage) {
    stage_ = stage;
    stage_start_ = now;
  }
  const milliseconds interval = style_ == Style::kBar    ? kBarInterval
                                : style_ == Style::kJson ? kJsonInterval
                                                         : kLineInterval;
  // Stages may follow each other faster than a person can read lines.
  const bool due = now >= next_print_ || (new_stage && style_ != Style::kLines);
  if (due && style_ != Style::kNone) {
    next_print_ = now + interval;
    print(fraction);
    bar_drawn_ = style_ == Style::kBar;
  }
  return !stopRequested();
}

void ProgressDisplay::print(double fraction) const {
  if (style_ == Style::kJson) {
    std::cout << jsonLine({{"stage", stage_}, {"fraction", fraction}}) << std::flush;
  } else if (style_ == Style::kLines) {
    std::cerr << stage_ << ": " << wholePercent(fraction) << " %" << timeLeft(fraction)
              << std::endl;
  } else {
    const int filled = kBarWidth * wholePercent(fraction) / 100;
    std::cerr << "\r\033[K" << stage_ << " [" << std::string(filled, '#')
              << std::string(kBarWidth - filled, ' ') << "] " << wholePercent(fraction) << " %"
              << timeLeft(fraction) << std::flush;
  }
}

std::string ProgressDisplay::timeLeft(double fraction) const {
  const double elapsed = duration<double>(Clock::now() - stage_start_).count();
  if (fraction <= 0.02 || fraction >= 1 || elapsed < 1) return "";
  const long seconds = std::lround(elapsed * (1 - fraction) / fraction);
  char text[48];
  if (seconds < 60) {
    std::snprintf(text, sizeof(text), ", %ld s left", seconds);
  } else {
    std::snprintf(text, sizeof(text), ", %ld min %02ld s left", seconds / 60, seconds % 60);
  }
  return text;
}

}  // namespace place_recognition::tool
