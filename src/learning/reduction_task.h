#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>

#include "learning/column_choice.h"
#include "learning/pivoted_qr.h"
#include "learning/reduction.h"

namespace place_recognition {

/// The arguments of factorize(), see reduction.h, and what its methods share.
struct ReductionTask {
  const BinarySvms& machines;
  const Eigen::MatrixXd& kernel_values;
  const ReductionOptions& options;
  const Progress& progress;
  /// Divisor of each column of `kernel_values` before factorization; never 0.
  Eigen::RowVectorXd scales;

  ChoiceLimits limitsFor(const PivotedQr& qr) const {
    const bool counted = options.share > 0 || options.support_vectors > 0;
    const Eigen::Index most = std::min(qr.candidates(), qr.rows());
    return {counted ? 0 : options.tau,
            std::min<Eigen::Index>(most, vectorLimit(options, machines))};
  }
};

/// Each machine separately, all with the same tau (section 6.3).
std::unique_ptr<const Reduction> factorizeEach(const ReductionTask& task);

/// All machines on one basis, fitted to their decision values.
std::unique_ptr<const Reduction> factorizeShared(const ReductionTask& task);

}  // namespace place_recognition
