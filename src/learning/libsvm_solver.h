#pragma once

#include <Eigen/Core>
#include <vector>

struct svm_node;

namespace place_recognition {

/// Trains binary C-SVC machines with libsvm on one Gram matrix, whose copy in libsvm's format (16
/// bytes an element) all machines share. solve() may be called from several threads at once.
class LibsvmSolver {
 public:
  explicit LibsvmSolver(const Eigen::MatrixXd& gram);
  ~LibsvmSolver();

  /// Separates vectors of sign +1 from those of sign -1 (0: not taken part), each sign at least
  /// once, at the price `c` of an error (eq. 5.26). Writes alpha_i y_i of every vector (eq. 5.32)
  /// into `weights`; returns the bias.
  double solve(const std::vector<int>& signs, double c, Eigen::Ref<Eigen::VectorXd> weights) const;

 private:
  std::vector<svm_node> nodes_;
  std::size_t size_;
};

}  // namespace place_recognition
