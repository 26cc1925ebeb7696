#pragma once

#include <place_recognition/PlaceRecognition.h>

#include <deque>
#include <optional>
#include <vector>

#include "place_recognition/fixed_lag_smoother.h"

namespace place_recognition {

/// Revises the answers to frames by the frames that follow: each message waits for the lag of a
/// FixedLagSmoother and is returned with its place. Not thread-safe.
class SmoothedAnswers {
 public:
  /// `lag`: s, 0..10.
  explicit SmoothedAnswers(double lag) : lag_(lag) {}

  /// Switches to messages of a filter with this adjacency and these options; calls finish().
  void follow(const Adjacency& adjacency, const TemporalFilterOptions& options);

  /// `message` answers the frame with which `filter` was last updated.
  void add(const TemporalFilter& filter, const PlaceRecognition& message);

  /// Answers the waiting messages with the frames seen so far.
  void finish();

  /// Discards all messages.
  void clear();

  /// Returns the completed messages in order, each once.
  std::vector<PlaceRecognition> take();

 private:
  void answer();

  double lag_;
  std::optional<FixedLagSmoother> smoother_;
  std::deque<PlaceRecognition> waiting_;  // as in the smoother
  std::vector<PlaceRecognition> done_;
};

}  // namespace place_recognition
