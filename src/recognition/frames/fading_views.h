#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// Means of a few values over the frames of a stream, for each place. Older frames fade, within
/// five minutes to 1/e. A place counts as no more than five views, however long the robot stays
/// there. Not thread-safe: use one per stream.
class FadingViews {
 public:
  FadingViews(Eigen::Index places, Eigen::Index values);

  void reset();

  /// Fades older frames up to `stamp` (s), that of the next frame. The first stamp, or a
  /// jump back by more than kTimeJump, starts anew.
  void beginFrame(double stamp);

  /// Adds that frame: its values for each place (places x values), assuming it shows that place,
  /// weighted by the places' probabilities. A frame within a second of the last one counts as that
  /// fraction of a second.
  void add(const Eigen::RowVectorXd& probabilities, const Eigen::MatrixXd& values);

  /// Sum_k v_k: the number of views that the frames are worth, where v_k = 1 / (1/n_k + 1/5).
  double views() const { return counts_.cwiseProduct(fractions()).sum(); }

  /// Sum_k v_k m_k, where m_k is the mean of each value over the frames of a place.
  Eigen::RowVectorXd sums() const { return fractions().transpose() * sums_; }

 private:
  Eigen::VectorXd fractions() const;  // v_k / n_k

  double stamp_ = 0;
  bool started_ = false;
  double fraction_ = 1;     // new fraction of the frame
  Eigen::VectorXd counts_;  // n_k
  Eigen::MatrixXd sums_;    // n_k m_k
};

}  // namespace place_recognition
