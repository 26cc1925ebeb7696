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

/// What odometry saw since the frame before.
struct Motion {
  double distance = 0;  ///< m, length of the way, >= 0
  double angle = 0;     ///< rad, sum of all turning, either way, >= 0
};

/// The answer over time.
struct FilteredAnswer {
  int place = -1;                    ///< index in Model::places; -1: unknown
  double confidence = 0;             ///< probability of `place`, or of 'unknown'
  Eigen::RowVectorXd probabilities;  ///< one per place, then 'unknown'; sum to 1
  bool changed = false;  ///< `place` differs from the last frame's, or this is the first frame
};

/// Turns the answers to single frames into a steady one: a hidden Markov model whose states are the
/// rooms and 'unknown', followed by the forward algorithm (Rabiner 1989). Between frames the belief
/// b moves as a chain in continuous time, see TransitionModel; a frame multiplies it by
/// likelihoods,
///   b_s <- b_s L_s^w / sum.
/// With the frame's evidence e, its probabilities p, the rooms' fractions q of the training images,
/// the unknown threshold T and a fraction o of frames that tell nothing, l = (1 - o) p_k / q_k + o,
///   L_k = ((1 - o) e / T + o) l_k / max l,    L_unknown = (1 - o) (1 - e) / (1 - T) + o.
/// Up to a factor that is the same for all, a posterior divided by its prior is the likelihood that
/// the chain needs (Bourlard and Morgan 1994); T is where the frame is as much for the rooms
/// together as against them. A room that is not known looks like the one it resembles most, so
/// which one that is tells nothing for or against 'unknown': hence the division by the largest.
///
/// Neighbouring frames show nearly the same, so w is the fraction of a frame that is new: time over
/// decorrelation time, at most 1. All is by stamps: the answers do not depend on the frame rate as
/// long as it is faster than that. Where odometry is given, the way driven takes the place of time:
/// a robot that stands is still in the same room and sees nothing new; one that turns sees
/// something new of the same room.
///
/// Several cameras have a w each, of their own frames. What they see at one moment is one moment
/// still: w is divided by the sum of a camera's correlations r with those that tell something now,
///   w_a <- w_a / Sum_b r_ab,  r_aa = 1.
/// Winkler (1981) gives n measurements of equal variance and correlation r this weight in their
/// joint likelihood, 1 / (1 + (n - 1) r): cameras that always err together count as one, and
/// independent ones in full.
///
/// Nothing is allocated after construction. Not thread-safe: one filter a robot.
class TemporalFilter {
 public:
  /// For the answers of a recognizer with `model`, of whose places `adjacency` is. Throws Error if
  /// an option is out of range.
  TemporalFilter(const Model& model, const Adjacency& adjacency,
                 const TemporalFilterOptions& options);
  /// The same for several cameras, 1 to kMaxCameras: `models` answers each of them, all of the same
  /// places; `correlation`: cameras x cameras, see CameraCorrelation.
  TemporalFilter(const std::vector<const Model*>& models, const Eigen::MatrixXd& correlation,
                 const Adjacency& adjacency, const TemporalFilterOptions& options);
  ~TemporalFilter();
  TemporalFilter(TemporalFilter&&) noexcept;
  TemporalFilter& operator=(TemporalFilter&&) noexcept;

  /// Takes the frame of time `stamp` (s). A stamp before the last one of its camera, or further
  /// than the maximum gap from the last one at all, starts anew; an equal one adds nothing. A frame
  /// that is earlier than another camera's last one counts as of that time. `motion`: since the
  /// last call, whichever camera that was of. The result stays valid until the next call.
  const FilteredAnswer& update(double stamp, const Recognition& recognition,
                               const std::optional<Motion>& motion = std::nullopt,
                               std::size_t camera = 0);

  /// The answer of the frame seen last.
  const FilteredAnswer& answer() const { return answer_; }

  /// Forgets all frames.
  void reset() { started_ = false; }

  /// The model's threshold until set, as Recognizer::setUnknownThreshold(); kept within 0.01..0.99.
  void setUnknownThreshold(double threshold, std::size_t camera = 0);

 private:
  friend class FixedLagSmoother;

  /// What a frame did to the belief.
  struct Step {
    double stamp = 0;                // s
    bool first = true;               // the filter began anew with this frame
    double changes = 0;              // mean number of changes of room since the frame before
    Eigen::RowVectorXd likelihoods;  // L^w; as answer().probabilities
  };

  struct Camera {
    Eigen::RowVectorXd room_fractions;  // q
    double unknown_threshold = 0;
    std::optional<double> stamp = {};  // s, of its last frame
    std::optional<double> told = {};   // s, of its last frame that told something
    double new_fraction = 1;           // w of its next frame, as if it were alone
  };

  void start();
  void move(double elapsed, const std::optional<Motion>& motion);
  double independentFraction(std::size_t camera) const;
  void weigh(const Recognition& recognition, std::size_t camera);
  void decide();

  TemporalFilterOptions options_;
  std::unique_ptr<TransitionModel> chain_;
  std::vector<Camera> cameras_;
  Eigen::MatrixXd correlation_;  // of the cameras
  bool started_ = false;
  int state_ = 0;  // answered; the number of rooms: 'unknown'
  double answer_since_ = 0;
  Step step_;
  FilteredAnswer answer_;
};

}  // namespace place_recognition
