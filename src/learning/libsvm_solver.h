#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/packed_gram.h"

namespace place_recognition {

/// Trains binary C-SVC machines with libsvm on some of the vectors of a Gram matrix, which must
/// outlive the solver. solve() may be called from several threads at once.
class LibsvmSolver {
 public:
  LibsvmSolver(const PackedGram& gram, const std::vector<int>& vectors);

  /// Separates vectors of sign +1 from those of sign -1 (0: not used), at least one of each sign,
  /// with penalty parameter `c` (eq. 5.26). Writes alpha_i y_i of every vector (eq. 5.32) to
  /// `weights`; returns the bias.
  double solve(const std::vector<int>& signs, double c, Eigen::Ref<Eigen::VectorXd> weights) const;

 private:
  std::vector<svm_node*> rows_;  ///< of each vector, in the Gram matrix
};

}  // namespace place_recognition
