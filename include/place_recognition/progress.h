#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace place_recognition {

/// Called from one thread at a time as work proceeds, with the stage's name in plain words and the
/// completed part of it, 0..1. Returning false requests a stop: the work then throws Cancelled.
using Progress = std::function<bool(const std::string& stage, double fraction)>;

/// The caller's Progress stopped the work. No half-written file is left behind.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("Cancelled.") {}
};

/// Reports to `progress`, which may be empty; throws Cancelled if it requests a stop.
inline void report(const Progress& progress, const std::string& stage, double fraction) {
  if (progress && !progress(stage, fraction)) throw Cancelled();
}

}  // namespace place_recognition
