#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "place_recognition/adjacency.h"
#include "place_recognition/recognizer.h"
#include "place_recognition/temporal_filter_options.h"

namespace place_recognition {

class TransitionModel;

/// Motion since the previous frame, from odometry.
struct Motion {
  double distance = 0;  ///< m, length of the path, >= 0
  double angle = 0;     ///< rad, sum of all turns in either direction, >= 0
};

/// The answer over time.
struct FilteredAnswer {
  int place = -1;                    ///< index in Model::places; -1: unknown
  double confidence = 0;             ///< probability of `place`, or of 'unknown'
  Eigen::RowVectorXd probabilities;  ///< one per place, then 'unknown'; sum to 1
  bool changed = false;  ///< `place` differs from the last frame's, or this is the first frame
};

/// Turns the answers to single frames into a steady answer: a hidden Markov model whose states are
/// the rooms and 'unknown', updated by the forward algorithm (Rabiner 1989). Between frames the
/// belief b evolves as a Markov chain in continuous time, see TransitionModel; a frame multiplies
/// it by likelihoods,
///   b_s <- b_s L_s^w / sum.
/// Let e be the frame's evidence, p its probabilities, q the rooms' fractions of the training
/// images, T the unknown threshold, and o the fraction of frames without information. With l_k = (1
/// - o) p_k / q_k + o,
///   L_k = ((1 - o) e / T + o) l_k / max l,    L_unknown = (1 - o) (1 - e) / (1 - T) + o.
/// A posterior divided by its prior is, up to a common factor, the likelihood that the chain needs
/// (Bourlard and Morgan 1994). At e = T a frame favours neither the rooms as a whole nor 'unknown'.
/// An unknown room looks like the known room that it resembles most, so which room that is says
/// nothing about 'unknown'; hence the division by the largest l.
///
/// Neighbouring frames show nearly the same, so w is the fraction of a frame that is new: the
/// elapsed time divided by the decorrelation time, at most 1. All times are stamps, so the answers
/// do not depend on the frame rate as long as frames are closer than the decorrelation time. If
/// there is odometry, the path travelled replaces time: a robot that stands still is still in the
/// same room and sees nothing new; a robot that turns sees something new of the same room.
///
/// Each of several cameras has its own w. What they see at the same moment is not independent, so w
/// is divided by the sum of a camera's correlations r with the cameras that currently contribute,
///   w_a <- w_a / Sum_b r_ab,  r_aa = 1.
/// Winkler (1981) gives n measurements of equal variance and correlation r this weight in their
/// joint likelihood, 1 / (1 + (n - 1) r): cameras that always err together count as one, and
/// independent cameras count in full.
///
/// Nothing is allocated after construction. Not thread-safe: use one filter per robot.
class TemporalFilter {
 public:
  /// Filters the answers of a recognizer with `model`; `adjacency` refers to its places. Throws
  /// Error if an option is out of range.
  TemporalFilter(const Model& model, const Adjacency& adjacency,
                 const TemporalFilterOptions& options);
  /// The same for 1 to kMaxCameras cameras: one of `models`, all of the same places, answers each
  /// camera. `correlation`: cameras x cameras, see CameraCorrelation.
  TemporalFilter(const std::vector<const Model*>& models, const Eigen::MatrixXd& correlation,
                 const Adjacency& adjacency, const TemporalFilterOptions& options);
  ~TemporalFilter();
  TemporalFilter(TemporalFilter&&) noexcept;
  TemporalFilter& operator=(TemporalFilter&&) noexcept;

  /// Adds a frame with the time `stamp` (s). The filter restarts if the stamp precedes the last one
  /// of the same camera, or differs from the last one of any camera by more than the maximum gap.
  /// An equal stamp without motion adds nothing. A frame earlier than another camera's last frame
  /// counts as of that frame's time. `motion`: since the last call, for whichever camera. The
  /// result stays valid until the next call.
  const FilteredAnswer& update(double stamp, const Recognition& recognition,
                               const std::optional<Motion>& motion = std::nullopt,
                               std::size_t camera = 0);

  /// The answer for the last frame.
  const FilteredAnswer& answer() const { return answer_; }

  /// Forgets all frames.
  void reset() { started_ = false; }

  /// Replaces the model's threshold, as Recognizer::setUnknownThreshold(); clamped to 0.01..0.99,
  /// not NaN.
  void setUnknownThreshold(double threshold, std::size_t camera = 0);

 private:
  friend class FixedLagSmoother;

  /// The effect of a frame on the belief.
  struct Step {
    double stamp = 0;                // s
    bool first = true;               // the filter restarted with this frame
    double changes = 0;              // mean number of changes of room since the previous frame
    Eigen::RowVectorXd likelihoods;  // L^w; in the order of answer().probabilities
  };

  struct Camera {
    Eigen::RowVectorXd room_fractions;  // q
    double unknown_threshold = 0;
    std::optional<double> stamp = {};  // s, of its last frame
    std::optional<double> told = {};   // s, of its last frame with information
    double new_fraction = 1;           // w of its next frame if there were no other camera
  };

  void start();
  void move(double elapsed, const std::optional<Motion>& motion);
  double independentFraction(std::size_t camera) const;
  void weigh(const Recognition& recognition, std::size_t camera);
  void decide();

  TemporalFilterOptions options_;
  std::unique_ptr<TransitionModel> chain_;
  std::vector<Camera> cameras_;
  Eigen::MatrixXd correlation_;  // between the cameras
  bool started_ = false;
  int state_ = 0;  // of the current answer; the number of rooms stands for 'unknown'
  double answer_since_ = 0;
  Step step_;
  FilteredAnswer answer_;
};

}  // namespace place_recognition
