#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace place_recognition {

/// Called from one thread at a time as work goes on: the stage's name in plain words and how much
/// of it is done, 0..1. Returning false asks for a stop: the work then ends by throwing Cancelled.
using Progress = std::function<bool(const std::string& stage, double fraction)>;

/// The work was stopped by the caller's Progress; nothing half-done is left behind.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("Cancelled.") {}
};

/// Reports to `progress`, which may be empty; throws Cancelled if it asks for a stop.
inline void report(const Progress& progress, const std::string& stage, double fraction) {
  if (progress && !progress(stage, fraction)) throw Cancelled();
}

}  // namespace place_recognition
