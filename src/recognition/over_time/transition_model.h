#pragma once

#include <Eigen/Core>

#include "place_recognition/adjacency.h"

namespace place_recognition {

/// How a robot moves between rooms: a Markov chain in continuous time over the rooms and, last, the
/// state 'unknown'. Every state is left at the same rate. From a room the chain goes to 'unknown'
/// as often as makes `unknown_share` its fraction of the time, else to an adjoining room or, in
/// `jump_share` of the cases, to any other; from 'unknown' to any room.
///
/// Not thread-safe.
class TransitionModel {
 public:
  TransitionModel(const Adjacency& adjacency, double unknown_share, double jump_share);

  /// Probabilities while nothing has been seen: `unknown_share`, the rest to all rooms alike.
  const Eigen::RowVectorXd& prior() const { return prior_; }

  /// Moves `belief` (rooms, then 'unknown'; sum 1) on by `changes`, the mean number of changes of
  /// room in the time passed: belief exp(changes (J - I)) for the matrix J of one change's
  /// probabilities. By uniformization (Jensen 1953) that is the mean of belief J^n over the Poisson
  /// distribution of n, a sum of positive terms. Two steps are as good as one of their sum.
  void advance(double changes, Eigen::RowVectorXd& belief);

  /// The other way: what `likelihood` of a later time, by state, says about the states `changes`
  /// before, exp(changes (J - I)) likelihood, up to a factor.
  void goBack(double changes, Eigen::RowVectorXd& likelihood);

 private:
  template <typename Matrix>
  void step(double changes, const Matrix& jump, Eigen::RowVectorXd& weights);

  Eigen::RowVectorXd prior_;
  Eigen::MatrixXd jump_;  // J, each row sums to 1
  Eigen::RowVectorXd term_, next_;
};

/// The state to answer by `belief` (rooms, then 'unknown'): the most probable one, or 'unknown' if
/// none is as probable as `least`.
int answeredState(const Eigen::RowVectorXd& belief, double least);

}  // namespace place_recognition
