#include "learning/reduction_task.h"

namespace place_recognition {

Eigen::MatrixXd reduceShared(const ReductionTask& task) {
  const Eigen::MatrixXd& weights = task.machines.weights;
  const std::vector<int> vectors = supportVectors(task.machines);
  const auto m = static_cast<Eigen::Index>(vectors.size());
  ColumnElimination elimination(task.kernel_values.rows(), m, weights.cols());
  for (Eigen::Index i = 0; i < m; ++i) {
    const int vector = vectors[static_cast<std::size_t>(i)];
    elimination.set(i, task.kernel_values.col(vector), task.scales[vector]);
  }
  const Eigen::MatrixXd margins = task.kernel_values * weights;  // without bias: F = K A
  for (Eigen::Index t = 0; t < weights.cols(); ++t) elimination.set(m + t, margins.col(t), 1);

  const ChoiceLimits limits = task.limitsFor(elimination);
  if (task.options.method == "shared-qr") {
    chooseByPivot(elimination, limits, task.progress);
  } else {
    chooseByFit(elimination, limits, task.progress);
  }

  const std::vector<Eigen::Index>& basis = elimination.chosen();
  const Eigen::MatrixXd fitted =  // least squares: R11 X = Q'F
      solveTriangular(elimination.r(), basis, elimination.r().rightCols(weights.cols()));
  Eigen::MatrixXd reduced = Eigen::MatrixXd::Zero(weights.rows(), weights.cols());
  for (std::size_t k = 0; k < basis.size(); ++k) {
    const int vector = vectors[static_cast<std::size_t>(basis[k])];
    reduced.row(vector) = fitted.row(static_cast<Eigen::Index>(k)) / task.scales[vector];
  }
  return reduced;
}

}  // namespace place_recognition
