#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "learning/column_choice.h"
#include "learning/column_elimination.h"
#include "learning/machines.h"
#include "place_recognition/learning_options.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// What reduce() is asked, see reduction.h, and what its methods have in common.
struct ReductionTask {
  const Machines& machines;
  const Eigen::MatrixXd& kernel_values;
  const ReductionOptions& options;
  const Progress& progress;
  /// What each column of `kernel_values` is divided by before it is factorised; never 0.
  Eigen::RowVectorXd scales;

  ChoiceLimits limitsFor(const ColumnElimination& elimination) const {
    const Eigen::Index most = std::min(elimination.candidates(), elimination.rows());
    if (options.support_vectors == 0) return {options.tau, most};
    return {0, std::min<Eigen::Index>(most, options.support_vectors)};
  }
};

/// The weights of each machine reduced by itself, all with the same tau (section 6.3).
Eigen::MatrixXd reduceEach(const ReductionTask& task);

/// The weights of all machines on one basis, fitted to their margins.
Eigen::MatrixXd reduceShared(const ReductionTask& task);

}  // namespace place_recognition
