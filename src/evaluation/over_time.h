#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evaluation/evaluation.h"

namespace place_recognition {

/// How often a way of answering named another room than the true one, and how often none.
struct AnswerCounts {
  std::uint64_t wrong = 0;
  std::uint64_t unknown = 0;
};

/// Answers to single frames and over time to the same frames.
struct BothAnswers {
  std::uint64_t frames = 0;
  AnswerCounts single;
  AnswerCounts filtered;
};

/// The answer over time (TemporalFilter) beside those to single frames, on runs that are drives
/// through the rooms; pictures of places that the model has learned.
struct OverTime {
  /// Where the robot is in a doorway, two rooms can be seen and an answer over time may lag behind.
  static constexpr double kSettling = 2;  // s

  BothAnswers all;
  BothAnswers settled;         ///< without the first kSettling after each change of room
  std::vector<double> delays;  ///< s, from each change of room until it is named, ascending
  std::uint64_t missed = 0;    ///< changes that were not followed before the next one

  /// Share of all changes that are followed within `seconds`.
  double followedWithin(double seconds) const;
};

/// Nothing if no run is a drive: pictures that are sorted by room have no order in time.
std::optional<OverTime> overTime(const Evaluation& evaluation);

}  // namespace place_recognition
