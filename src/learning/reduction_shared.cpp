#include "learning/reduction_task.h"

namespace place_recognition {
namespace {

/// The columns of the support vectors, with the decision values as targets.
PivotedQr factorizationOf(const ReductionTask& task, const std::vector<int>& vectors) {
  const Eigen::MatrixXd& weights = task.machines.weights;
  const auto m = static_cast<Eigen::Index>(vectors.size());
  PivotedQr qr(task.kernel_values.rows(), m, weights.cols());
  for (Eigen::Index i = 0; i < m; ++i) {
    const int vector = vectors[static_cast<std::size_t>(i)];
    qr.set(i, task.kernel_values.col(vector), task.scales[vector]);
  }
  const Eigen::MatrixXd decision_values = task.kernel_values * weights;  // without bias: F = K A
  for (Eigen::Index t = 0; t < weights.cols(); ++t) qr.set(m + t, decision_values.col(t), 1);
  return qr;
}

class SharedReduction : public Reduction {
 public:
  explicit SharedReduction(const ReductionTask& task)
      : machines_(task.machines), scales_(task.scales) {
    const std::vector<int> vectors = supportVectors(machines_);
    PivotedQr qr = factorizationOf(task, vectors);
    const ChoiceLimits limits = task.limitsFor(qr);
    norms_ = task.options.method == "shared-qr"
                 ? chooseByPivot(qr, limits, task.progress)
                 : orthogonalMatchingPursuit(qr, limits, task.progress);
    r11_.resize(qr.rank(), qr.rank());
    for (const Eigen::Index column : qr.chosen()) {
      r11_.col(static_cast<Eigen::Index>(basis_.size())) = qr.r().col(column);
      basis_.push_back(vectors[static_cast<std::size_t>(column)]);
    }
    targets_ = qr.r().rightCols(machines_.weights.cols());
  }

  BinarySvms withVectors(int count) const override {
    return withRank(std::min<Eigen::Index>(count, r11_.cols()));
  }

  BinarySvms withTau(double tau) const override { return withRank(rankAt(norms_, tau)); }

  std::vector<double> thresholds() const override {
    return {norms_.data(), norms_.data() + norms_.size()};
  }

 private:
  BinarySvms withRank(Eigen::Index rank) const {
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

  BinarySvms machines_;
  Eigen::RowVectorXd scales_;
  std::vector<int> basis_;   ///< in the order of selection
  Eigen::VectorXd norms_;    ///< see column_choice.h
  Eigen::MatrixXd r11_;      ///< of the basis
  Eigen::MatrixXd targets_;  ///< Q'F
};

}  // namespace

std::unique_ptr<const Reduction> factorizeShared(const ReductionTask& task) {
  return std::make_unique<SharedReduction>(task);
}

}  // namespace place_recognition
