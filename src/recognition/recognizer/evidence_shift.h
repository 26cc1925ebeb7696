#pragma once

#include <Eigen/Core>

#include "place_recognition/model.h"
#include "recognition/frames/fading_views.h"

namespace place_recognition {

/// Estimates how much less evident the places are in a stream of frames than in the training. In
/// other light, or after a year, decision values and familiarity of all rooms decrease together,
/// and with the threshold from the training most frames would be answered 'unknown'.
///
/// The expected values for a frame of place k come from the frames held out in training: u_k is the
/// log odds of evidence, and c_k is the lead of the largest decision value over the second, in
/// standard deviations of a frame's decision values. For the frames of a stream, with the views v_k
/// of each place (see FadingViews),
///   drop  = Sum_k v_k (u_k - u) / (1 + Sum_k v_k),
///   ratio = (2 * 0.45 + Sum_k v_k c / c_k) / (2 + Sum_k v_k),
///   shift = drop, clamped to 0..4, times (ratio - 0.45) / 0.1, clamped to 0..1.
/// The lead does not depend on the size of the decision values. In other light one room still
/// leads; in an unknown building none does, and the evidence stays unchanged. A room that was not
/// learned remains less evident than the others. Not thread-safe: use one per stream.
class EvidenceShift {
 public:
  /// The shift stays 0 for a model with two places, of which one always leads, and for a model
  /// without held-out frames.
  explicit EvidenceShift(const Model& model);

  /// See FadingViews.
  void beginFrame(double stamp);

  /// Adds that frame: the recognizer's probabilities, the mean decision values without a limit, and
  /// the unshifted log odds of evidence. A value that is not finite is ignored.
  void add(const Eigen::RowVectorXd& probabilities, const Eigen::RowVectorXd& decision_values,
           double log_odds);

  /// Forgets all frames.
  void reset();

  /// The amount to add to the log odds of evidence, 0..4. The median frame of the training is 3
  /// above the threshold of 'unknown'.
  double value() const;

 private:
  Eigen::VectorXd log_odds_;  // u_k; empty: the shift stays 0
  Eigen::VectorXd leads_;     // c_k
  FadingViews views_;         // of u_k - u and c / c_k
};

}  // namespace place_recognition
