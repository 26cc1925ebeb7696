#include "learning/reduction.h"

#include <cassert>

#include "learning/reduction_task.h"

namespace place_recognition {

Machines reduce(const Machines& machines, const Eigen::MatrixXd& kernel_values,
                const ReductionOptions& options, const Progress& progress) {
  options.check();
  assert(kernel_values.cols() == machines.weights.rows());
  if (options.method == "none" || supportVectors(machines).empty()) return machines;

  ReductionTask task{machines, kernel_values, options, progress,
                     Eigen::RowVectorXd::Ones(kernel_values.cols())};
  if (options.normalise) task.scales = kernel_values.colwise().norm();
  task.scales = (task.scales.array() > 0).select(task.scales, 1);

  Machines reduced = machines;
  reduced.weights = options.method == "qr" ? reduceEach(task) : reduceShared(task);
  return reduced;
}

}  // namespace place_recognition
