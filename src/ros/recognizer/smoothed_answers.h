#pragma once

#include <place_recognition/PlaceRecognition.h>

#include <deque>
#include <optional>
#include <vector>

#include "place_recognition/fixed_lag_smoother.h"

namespace place_recognition {

/// Answers to frames in the light of what came after them: each message waits for the frames of a
/// FixedLagSmoother's lag and comes back with its place. Not thread-safe.
class SmoothedAnswers {
 public:
  /// `lag`: s, 0..10.
  explicit SmoothedAnswers(double lag) : lag_(lag) {}

  /// From now on messages are of a filter with this map and these options; calls finish().
  void follow(const Adjacency& adjacency, const TemporalFilterOptions& options);

  /// `message` answers the frame that `filter` has been updated with last.
  void add(const TemporalFilter& filter, const PlaceRecognition& message);

  /// Answers the messages that wait by what has been seen so far.
  void finish();

  /// Forgets all messages.
  void clear();

  /// Those that are done, in order, each once.
  std::vector<PlaceRecognition> take();

 private:
  void answer();

  double lag_;
  std::optional<FixedLagSmoother> smoother_;
  std::deque<PlaceRecognition> waiting_;  // as in the smoother
  std::vector<PlaceRecognition> done_;
};

}  // namespace place_recognition
