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
struct AnswersOverTime {
  std::uint64_t frames = 0;
  AnswerCounts single;
  AnswerCounts filtered;
  AnswerCounts smoothed;
};

/// The answers over time (TemporalFilter, FixedLagSmoother) beside those to single frames, on runs
/// that are drives through the rooms; images of places that the model has learned.
struct OverTime {
  /// In a doorway a camera sees the next room before the robot is in it, and an answer over time
  /// follows late: what is from kBefore before to kAfter after a change of room, s.
  static constexpr double kBefore = 1;
  static constexpr double kAfter = 2;

  AnswersOverTime all;
  AnswersOverTime settled;     ///< without those in doorways
  std::vector<double> delays;  ///< s, until the filter names the room after a change, ascending
  std::uint64_t missed = 0;    ///< changes that were not followed before the next one

  /// Fraction of all changes that are followed within `seconds`.
  double followedWithin(double seconds) const;
};

/// Whether the frames of a recording, of one of so many places each, can have been taken on the
/// way.
bool isDrive(const std::vector<const FrameResult*>& recording, std::size_t places);

/// Nothing if no run is a drive: images that are sorted by room have no order in time.
std::optional<OverTime> overTime(const Evaluation& evaluation);

}  // namespace place_recognition
