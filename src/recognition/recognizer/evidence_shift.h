#pragma once

#include <Eigen/Core>

#include "place_recognition/model.h"
#include "recognition/frames/fading_views.h"

namespace place_recognition {

/// How much less evident the places are in a stream of frames than they were in the training: in
/// other light, or after a year, decision values and familiarity of every room fall alike, and with
/// the threshold of the training most frames would be 'unknown'.
///
/// A place that answers is expected to have the log odds of evidence u_k and the lead c_k of the
/// largest decision value over the second, in standard deviations of a frame's decision values,
/// that the frames held out from training have. For the frames of a stream, with the views v_k of
/// each place (see FadingViews),
///   drop  = Sum_k v_k (u_k - u) / (1 + Sum_k v_k),
///   ratio = (2 * 0.5 + Sum_k v_k c / c_k) / (2 + Sum_k v_k),
///   shift = drop, kept within 0..4, times (ratio - 0.5) / 0.1, kept within 0..1.
/// The lead does not depend on how strong decision values are. In other light one room still stands
/// out; in a strange building none does, and the evidence stays as it is. A room that the training
/// lacks stays less evident than the others. Not thread-safe: one per stream.
class EvidenceShift {
 public:
  /// The shift stays 0 for a model of two places, of which one always stands out, and for one that
  /// kept no held-out frames.
  explicit EvidenceShift(const Model& model);

  /// See FadingViews.
  void beginFrame(double stamp);

  /// Takes that frame: what the recognizer found, with the log odds of evidence as the calibration
  /// has them. One that is not finite tells nothing.
  void add(const Eigen::RowVectorXd& probabilities, const Eigen::RowVectorXd& decision_values,
           double log_odds);

  /// Forgets all frames.
  void reset();

  /// What is to be added to the log odds of evidence, 0..4. The median frame of the training lies
  /// 3 above the threshold of 'unknown'.
  double value() const;

 private:
  Eigen::VectorXd log_odds_;  // u_k; none: the shift stays 0
  Eigen::VectorXd leads_;     // c_k
  FadingViews views_;         // of u_k - u and c / c_k
};

}  // namespace place_recognition
