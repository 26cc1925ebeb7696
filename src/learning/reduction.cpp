#include "learning/reduction.h"

#include <cassert>
#include <cmath>

#include "base/parallel.h"
#include "learning/reduction_task.h"

namespace place_recognition {
namespace {

/// Keeps the machines unchanged.
class NoReduction : public Reduction {
 public:
  explicit NoReduction(const BinarySvms& machines) : machines_(machines) {}
  BinarySvms withVectors(int) const override { return machines_; }
  BinarySvms withTau(double) const override { return machines_; }
  std::vector<double> thresholds() const override { return {}; }

 private:
  BinarySvms machines_;
};

/// The start of the variants of each method, and the end of the last one.
std::vector<std::size_t> methodBounds(const std::vector<ReductionOptions>& variants) {
  std::vector<std::size_t> bounds;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (i == 0 || variants[i].method != variants[i - 1].method) bounds.push_back(i);
  }
  bounds.push_back(variants.size());
  return bounds;
}

}  // namespace

std::unique_ptr<const Reduction> factorize(const BinarySvms& machines,
                                           const Eigen::MatrixXd& kernel_values,
                                           const ReductionOptions& options,
                                           const Progress& progress) {
  options.check();
  assert(options.method != "auto" && kernel_values.cols() == machines.weights.rows());
  if (options.method == "none" || supportVectors(machines).empty()) {
    return std::make_unique<NoReduction>(machines);
  }
  ReductionTask task{machines, kernel_values, options, progress,
                     Eigen::RowVectorXd::Ones(kernel_values.cols())};
  if (options.normalize) task.scales = kernel_values.colwise().norm();
  task.scales = (task.scales.array() > 0).select(task.scales, 1);
  return options.method == "qr" ? factorizeEach(task) : factorizeShared(task);
}

BinarySvms reduce(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                  const ReductionOptions& options, const Progress& progress) {
  return factorize(machines, kernel_values, options, progress)
      ->withVectors(vectorLimit(options, machines));
}

std::vector<BinarySvms> reduceEach(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                                   const std::vector<ReductionOptions>& variants,
                                   unsigned threads) {
  std::vector<BinarySvms> reduced(variants.size());
  const std::vector<std::size_t> bounds = methodBounds(variants);
  parallelFor(bounds.size() - 1, threads, [&](std::size_t method, unsigned) {
    const auto reduction = factorize(machines, kernel_values, variants[bounds[method]]);
    for (std::size_t i = bounds[method]; i < bounds[method + 1]; ++i) {
      reduced[i] = reduction->withVectors(vectorLimit(variants[i], machines));
    }
  });
  return reduced;
}

int vectorLimit(const ReductionOptions& options, const BinarySvms& machines) {
  const int all = static_cast<int>(supportVectors(machines).size());
  if (options.support_vectors > 0) return std::min(all, options.support_vectors);
  if (options.share > 0) return static_cast<int>(std::ceil(options.share * all));
  return all;
}

}  // namespace place_recognition
