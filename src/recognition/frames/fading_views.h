#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// What the frames of a stream show of each place, as means of a few values. Older frames fade,
/// within five minutes to 1/e, and a place tells no more than five views of it would, however long
/// the robot stands there. Not thread-safe: one per stream.
class FadingViews {
 public:
  FadingViews(Eigen::Index places, Eigen::Index values);

  void reset();

  /// Lets older frames fade until `stamp` (s), that of the next frame. A stamp more than a second
  /// before the last one begins anew; so does the first one.
  void beginFrame(double stamp);

  /// Takes that frame: what it shows of each place (places x values), if it is the place, by the
  /// probability of each. A frame that follows within a second counts by that part of a second.
  void add(const Eigen::RowVectorXd& probabilities, const Eigen::MatrixXd& values);

  /// Sum_k v_k: how many views the frames are worth; those of a place v_k = 1 / (1/n_k + 1/5).
  double views() const { return counts_.cwiseProduct(fractions()).sum(); }

  /// Sum_k v_k m_k, with the mean m_k of each value over the frames of a place.
  Eigen::RowVectorXd sums() const { return fractions().transpose() * sums_; }

 private:
  Eigen::VectorXd fractions() const;  // v_k / n_k

  double stamp_ = 0;
  bool started_ = false;
  double fraction_ = 1;     // of the frame that is new
  Eigen::VectorXd counts_;  // n_k
  Eigen::MatrixXd sums_;    // n_k m_k
};

}  // namespace place_recognition
