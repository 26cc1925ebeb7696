#pragma once

#include <Eigen/Core>

#include "place_recognition/colour_statistics.h"
#include "recognition/frames/fading_views.h"
#include "recognition/frames/light.h"

namespace place_recognition {

/// Estimates how the light of a stream of frames differs from that of the training: one gain per
/// channel, whose logarithm is added to that of a frame's mean levels.
///
/// The colour c_t of a frame (see logColour()) of place k is c_t = mu_k + g + e_t, where mu_k is
/// the mean of the place's training images and e_t has their covariance S. The recognizer's
/// probabilities determine how much of a frame counts for which place. Let r_k be the mean of c_t -
/// mu_k over the n_k frames of a place; its covariance is V_k = S / views (see FadingViews). A
/// priori the light most often equals that of the training, and otherwise g ~ N(0, G):
///   P = Sum_k V_k^-1,  b = Sum_k V_k^-1 r_k,  g = (P + G^-1)^-1 b,
///   log odds(changed) = log(1/3) - log |I + G P| / 2 + b' g / 2.
/// The estimate is odds / (1 + odds) g. Any change other than a gain per channel is treated as
/// noise. Not thread-safe: use one per stream.
class LightEstimate {
 public:
  explicit LightEstimate(const ColourStatistics& training);

  /// Fades older frames up to `stamp` (s), that of the next frame, see FadingViews.
  void beginFrame(double stamp);

  /// Adds that frame: its logColour() before correction, and the recognizer's probabilities for it.
  void add(const Eigen::RowVector3d& colour, const Eigen::RowVectorXd& probabilities);

  /// Forgets all frames.
  void reset();

  /// The gains that make frames look as in the training.
  const Light& correction() const { return correction_; }

  /// Certainty of the light: 1 / (1 + v / 0.15^2), where v is the variance of the estimate,
  /// averaged over the channels. About 1/4 before the first frame.
  double certainty() const { return certainty_; }

 private:
  void estimate();

  ColourStatistics training_;
  Eigen::Matrix3d precision_;  // S^-1
  FadingViews views_;          // of r_k
  Light correction_;
  double certainty_ = 1;
};

}  // namespace place_recognition
