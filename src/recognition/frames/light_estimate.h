#pragma once

#include <Eigen/Core>

#include "place_recognition/colour_statistics.h"
#include "recognition/frames/fading_views.h"
#include "recognition/frames/light.h"

namespace place_recognition {

/// How the light of a stream of frames differs from that of the training: a gain per channel,
/// which is added to the logarithm of a frame's mean levels.
///
/// A frame c_t (see logColor()) of place k is c_t = mu_k + g + e_t, with the mean mu_k of the
/// place's training images and their covariance S about it. The recognizer's probabilities say how
/// much of a frame counts for which place. The mean r_k of the n_k frames of a place less mu_k has
/// the covariance V_k = S / views (see FadingViews). The light is most often that of the training,
/// and else g ~ N(0, G):
///   P = Sum_k V_k^-1,  b = Sum_k V_k^-1 r_k,  g = (P + G^-1)^-1 b,
///   log odds(changed) = log(1/3) - log |I + G P| / 2 + b' g / 2.
/// The estimate is odds / (1 + odds) g. Every other change than a gain per channel is noise to it.
/// Not thread-safe: one per stream.
class LightEstimate {
 public:
  explicit LightEstimate(const ColourStatistics& training);

  /// Lets older frames fade until `stamp` (s), that of the next frame, see FadingViews.
  void beginFrame(double stamp);

  /// Takes that frame: its logColor() as it came, and what the recognizer answered to it.
  void add(const Eigen::RowVector3d& colour, const Eigen::RowVectorXd& probabilities);

  /// Forgets all frames.
  void reset();

  /// What frames are to be multiplied by to look as in the training.
  const Light& correction() const { return correction_; }

  /// How well the light is known: 1 / (1 + v / 0.15^2), with the variance v of the estimate, mean
  /// of the channels. About 1/4 before the first frame.
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
