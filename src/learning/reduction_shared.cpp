#include "learning/reduction_task.h"

namespace place_recognition {
namespace {

/// The columns of the support vectors, with the margins as targets.
PivotedQr eliminationOf(const ReductionTask& task, const std::vector<int>& vectors) {
  const Eigen::MatrixXd& weights = task.machines.weights;
  const auto m = static_cast<Eigen::Index>(vectors.size());
  PivotedQr elimination(task.kernel_values.rows(), m, weights.cols());
  for (Eigen::Index i = 0; i < m; ++i) {
    const int vector = vectors[static_cast<std::size_t>(i)];
    elimination.set(i, task.kernel_values.col(vector), task.scales[vector]);
  }
  const Eigen::MatrixXd margins = task.kernel_values * weights;  // without bias: F = K A
  for (Eigen::Index t = 0; t < weights.cols(); ++t) elimination.set(m + t, margins.col(t), 1);
  return elimination;
}

class SharedReduction : public Reduction {
 public:
  explicit SharedReduction(const ReductionTask& task)
      : machines_(task.machines), scales_(task.scales) {
    const std::vector<int> vectors = supportVectors(machines_);
    PivotedQr elimination = eliminationOf(task, vectors);
    const ChoiceLimits limits = task.limitsFor(elimination);
    if (task.options.method == "shared-qr") {
      chooseByPivot(elimination, limits, task.progress);
    } else {
      orthogonalMatchingPursuit(elimination, limits, task.progress);
    }
    r11_.resize(elimination.rank(), elimination.rank());
    for (const Eigen::Index column : elimination.chosen()) {
      r11_.col(static_cast<Eigen::Index>(basis_.size())) = elimination.r().col(column);
      basis_.push_back(vectors[static_cast<std::size_t>(column)]);
    }
    targets_ = elimination.r().rightCols(machines_.weights.cols());
  }

  BinarySvms withVectors(int count) const override {
    const Eigen::Index rank = std::min<Eigen::Index>(count, r11_.cols());
    const Eigen::MatrixXd fitted =  // least squares: R11 X = Q'F
        r11_.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(targets_.topRows(rank));
    BinarySvms reduced = machines_;
    reduced.weights.setZero();
    for (Eigen::Index k = 0; k < rank; ++k) {
      const int vector = basis_[static_cast<std::size_t>(k)];
      reduced.weights.row(vector) = fitted.row(k) / scales_[vector];
    }
    return reduced;
  }

 private:
  BinarySvms machines_;
  Eigen::RowVectorXd scales_;
  std::vector<int> basis_;   ///< in the order of the choice
  Eigen::MatrixXd r11_;      ///< of the basis
  Eigen::MatrixXd targets_;  ///< Q'F
};

}  // namespace

std::unique_ptr<const Reduction> factoriseShared(const ReductionTask& task) {
  return std::make_unique<SharedReduction>(task);
}

}  // namespace place_recognition
