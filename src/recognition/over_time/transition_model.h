#pragma once

#include <Eigen/Core>

#include "place_recognition/adjacency.h"

namespace place_recognition {

/// Models how a robot moves between rooms: a Markov chain in continuous time whose states are the
/// rooms and, last, 'unknown'. Every state is left at the same rate. From a room the chain changes
/// to 'unknown' just often enough to spend `unknown_share` of the time there; otherwise to an
/// adjoining room or, in `jump_share` of the cases, to any other. From 'unknown' it changes to any
/// room.
///
/// Not thread-safe.
class TransitionModel {
 public:
  TransitionModel(const Adjacency& adjacency, double unknown_share, double jump_share);

  /// Probabilities before any frame: `unknown_share`, and the rest equally for all rooms.
  const Eigen::RowVectorXd& prior() const { return prior_; }

  /// Advances `belief` (rooms, then 'unknown'; sum 1) by `changes`, the mean number of changes of
  /// room in the elapsed time: belief exp(changes (J - I)), where J is the matrix of one change's
  /// probabilities. By uniformization (Jensen 1953) this is the mean of belief J^n over the Poisson
  /// distribution of n, a sum of positive terms. Two steps are equivalent to one step of their sum.
  void advance(double changes, Eigen::RowVectorXd& belief);

  /// The backward step: converts `likelihood` by state at a later time to the likelihood `changes`
  /// earlier, exp(changes (J - I)) likelihood, up to a factor.
  void goBack(double changes, Eigen::RowVectorXd& likelihood);

 private:
  template <typename Matrix>
  void step(double changes, const Matrix& jump, Eigen::RowVectorXd& weights);

  Eigen::RowVectorXd prior_;
  Eigen::MatrixXd jump_;  // J, each row sums to 1
  Eigen::RowVectorXd term_, next_;
};

/// The state to answer given `belief` (rooms, then 'unknown'): the most probable one, or 'unknown'
/// if its probability is less than `least`.
int answeredState(const Eigen::RowVectorXd& belief, double least);

}  // namespace place_recognition
