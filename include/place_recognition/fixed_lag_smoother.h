#pragma once

#include <Eigen/Core>
#include <deque>
#include <memory>

#include "place_recognition/temporal_filter.h"

namespace place_recognition {

/// Answers each frame `lag` seconds late, after looking at the frames that follow it: the
/// forward-backward algorithm (Rabiner 1989) over a moving window. A TemporalFilter follows a
/// change of room with a short delay, and may take a short run of errors for a change; the smoother
/// also knows the later frames. Use it for logs and maps, whose answers belong to the frames'
/// stamps.
///
/// Let b be the filter's belief after the frame. From the last frame n of the window back to this
/// frame,
///   beta_n = 1,   beta_i = exp(changes_(i+1) (J - I)) (L_(i+1)^w beta_(i+1)),
/// and the answer is the largest element of b beta / sum. The cost grows with the number of frames
/// in the lag. Each frame is returned once, in the order of arrival. Neither copyable nor movable.
/// Not thread-safe.
class FixedLagSmoother {
 public:
  /// Bounds memory if the stamps do not advance.
  static constexpr std::size_t kMaxFrames = 1000;

  /// Smooths the output of a TemporalFilter built with the same adjacency and options. `lag`: s,
  /// >= 0. Throws Error if an option is out of range.
  FixedLagSmoother(const Adjacency& adjacency, const TemporalFilterOptions& options, double lag);
  ~FixedLagSmoother();

  /// Adds the frame with which `filter`, the same one in every call, was last updated.
  void add(const TemporalFilter& filter);

  /// Whether next() has an answer: the window covers the lag, or no frame will follow the oldest
  /// one because the filter restarted after it or finish() was called.
  bool ready() const;

  /// The answer for the oldest frame; requires ready(). Valid until the next call. `changed` refers
  /// to the sequence of these answers.
  const FilteredAnswer& next();

  /// States that no frame will follow soon, so the answers stop waiting for more.
  void finish() { finished_ = true; }

  /// Forgets all frames.
  void clear() { seen_.clear(); }

 private:
  struct Seen {
    TemporalFilter::Step step;
    Eigen::RowVectorXd belief;
  };
  std::size_t windowEnd() const;

  std::unique_ptr<TransitionModel> chain_;
  double minimum_confidence_;
  double lag_;
  bool finished_ = false;
  std::deque<Seen> seen_;    // the oldest first
  Eigen::RowVectorXd beta_;  // of the frames after
  FilteredAnswer answer_;
};

}  // namespace place_recognition
