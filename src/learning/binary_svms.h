#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/packed_gram.h"
#include "place_recognition/learning_options.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// Binary machines over n common vectors: the decision value of machine j is f_j(x) = sum_i
/// weights(i, j) K(x_i, x) + biases(j), where weights = alpha_i y_i (eq. 5.32).
struct BinarySvms {
  std::size_t places = 0;
  bool one_against_one = false;  ///< else one-against-all: machine j separates j from the rest
  Eigen::MatrixXd weights;       ///< n x machines
  Eigen::RowVectorXd biases;     ///< machines

  /// Machine decision values, one row per row of `kernel_values` (any x n).
  Eigen::MatrixXd decisionValues(const Eigen::MatrixXd& kernel_values) const;
};

/// Number of machines. One-against-one: one machine per pair (a, b), a < b, positive for a, in the
/// order (0,1), (0,2), ..., (1,2), ... One-against-all: one machine per place.
std::size_t machineCount(std::size_t places, bool one_against_one);

/// One value per place from the machines' decision values (rows: frames); the largest is the
/// answer. For one-against-all it is the decision value itself (eq. 5.41). For one-against-one it
/// is the number of votes plus s / (3 (|s| + 1)), where s is the sum of the place's signed decision
/// values; this term breaks ties but never outweighs a vote.
Eigen::MatrixXd placeValues(const BinarySvms& machines, const Eigen::MatrixXd& machine_values);

/// Trains every machine on some of the vectors of a Gram matrix, all of which have a column in it,
/// with C-SVC (libsvm, precomputed kernel). `labels`: place 0..places-1 of each of `vectors`. A
/// place or pair without vectors of both signs gives a machine with zero weights and bias -1 or +1.
/// The result does not depend on `threads`. `progress`: of "Training".
BinarySvms trainMachines(const PackedGram& gram, const std::vector<int>& vectors,
                         const std::vector<int>& labels, std::size_t places,
                         const SvmOptions& options, unsigned threads = 1,
                         const Progress& progress = {});
/// The same on all vectors of a Gram matrix (n x n), which is copied.
BinarySvms trainMachines(const Eigen::MatrixXd& gram, const std::vector<int>& labels,
                         std::size_t places, const SvmOptions& options, unsigned threads = 1);

/// Indices of the rows of `machines.weights` that are not all zero, that is, of the support
/// vectors.
std::vector<int> supportVectors(const BinarySvms& machines);

}  // namespace place_recognition
