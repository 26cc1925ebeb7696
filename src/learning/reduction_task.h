#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>

#include "learning/column_choice.h"
#include "learning/pivoted_qr.h"
#include "learning/reduction.h"

namespace place_recognition {

/// What factorize() is asked, see reduction.h, and what its methods have in common.
struct ReductionTask {
  const BinarySvms& machines;
  const Eigen::MatrixXd& kernel_values;
  const ReductionOptions& options;
  const Progress& progress;
  /// What each column of `kernel_values` is divided by before it is factorized; never 0.
  Eigen::RowVectorXd scales;

  ChoiceLimits limitsFor(const PivotedQr& qr) const {
    const bool counted = options.share > 0 || options.support_vectors > 0;
    const Eigen::Index most = std::min(qr.candidates(), qr.rows());
    return {counted ? 0 : options.tau,
            std::min<Eigen::Index>(most, vectorLimit(options, machines))};
  }
};

/// Each machine by itself, all with the same tau (section 6.3).
std::unique_ptr<const Reduction> factoriseEach(const ReductionTask& task);

/// All machines on one basis, fitted to their decision values.
std::unique_ptr<const Reduction> factoriseShared(const ReductionTask& task);

}  // namespace place_recognition
