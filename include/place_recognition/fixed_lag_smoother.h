#pragma once

#include <Eigen/Core>
#include <deque>
#include <memory>

#include "place_recognition/temporal_filter.h"

namespace place_recognition {

/// The answer about a frame that waits for what the camera sees in the `lag` after it: the
/// forward-backward algorithm (Rabiner 1989) over a window that moves along. Where a TemporalFilter
/// follows a change of room a moment late and takes a short row of mistakes for one, this one knows
/// how it went on. For logs and maps, whose answers belong to the frames' stamps.
///
/// With the filter's belief b after the frame and, from the last frame n of the window down to it,
///   beta_n = 1,   beta_i = exp(changes_(i+1) (J - I)) (L_(i+1)^w beta_(i+1)),
/// the answer is the largest of b beta / sum. Its cost grows with the frames in the lag. Frames
/// come out as they went in, each once. Neither copied nor moved. Not thread-safe.
class FixedLagSmoother {
 public:
  /// Bounds memory where stamps stand still.
  static constexpr std::size_t kMaxFrames = 1000;

  /// Smooths the output of a TemporalFilter built with the same adjacency and options. `lag`: s,
  /// >= 0. Throws Error if an option is out of range.
  FixedLagSmoother(const Adjacency& adjacency, const TemporalFilterOptions& options, double lag);
  ~FixedLagSmoother();

  /// Takes the frame that `filter`, always the same one, has been updated with last.
  void add(const TemporalFilter& filter);

  /// Whether next() has an answer: the frames of the lag are there, or none will follow the oldest
  /// frame, because the filter has begun anew after it or finish() was called.
  bool ready() const;

  /// The answer about the oldest frame, which must be ready(). Valid until the next call; `changed`
  /// as in the order of these answers.
  const FilteredAnswer& next();

  /// No frame follows soon: what is there is all that the answers can wait for.
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
