#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evaluation/evaluation.h"

namespace place_recognition {

/// Number of wrong answers and of answers 'unknown'.
struct AnswerCounts {
  std::uint64_t wrong = 0;
  std::uint64_t unknown = 0;
};

/// Counts of the answers to single frames and over time for the same frames.
struct AnswersOverTime {
  std::uint64_t frames = 0;
  AnswerCounts single;
  AnswerCounts filtered;
  AnswerCounts smoothed;
};

/// Compares the answers over time (TemporalFilter, FixedLagSmoother) with those to single frames,
/// on runs that are drives through the rooms and images of learned places.
struct OverTime {
  /// In a doorway the camera sees the next room before the robot enters it, and the answer over
  /// time follows with a delay. Doorway frames are those from kBefore before to kAfter after a
  /// change of room, s.
  static constexpr double kBefore = 1;
  static constexpr double kAfter = 2;

  AnswersOverTime all;
  AnswersOverTime settled;     ///< without doorway frames
  std::vector<double> delays;  ///< s, until the filter names the room after a change, ascending
  std::uint64_t missed = 0;    ///< changes that the filter did not follow before the next one

  /// Fraction of all changes that the filter follows within `seconds`.
  double followedWithin(double seconds) const;
};

/// Whether the frames of a recording, each of one of `places` places, can come from a drive.
bool isDrive(const std::vector<const FrameResult*>& recording, std::size_t places);

/// Nothing if no run is a drive: images sorted by room have no order in time.
std::optional<OverTime> overTime(const Evaluation& evaluation);

}  // namespace place_recognition
