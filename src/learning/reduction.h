#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "learning/binary_svms.h"
#include "place_recognition/learning_options.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// Support vector reduction, thesis chapter 6: fewer vectors, nearly the same decision values.
///
/// none            the machines unchanged
/// qr              each machine on its own support vectors; weights by eq. 6.21
/// shared-qr       one pivoted QR of all columns, one basis for all machines, weights refitted
/// shared-greedy   orthogonal matching pursuit: adds one vector at a time to a basis that best
///                 reproduces the decision values of all machines on the training vectors, weights
///                 refitted
///
/// Every method selects its vectors one after another, so a reduction to N vectors contains all
/// vectors of a smaller one. Immutable.
class Reduction {
 public:
  virtual ~Reduction() = default;

  /// The machines with at most `count` vectors of nonzero weights: the same as with options that
  /// request `count`.
  virtual BinarySvms withVectors(int count) const = 0;

  /// The same as with options that request `tau`, limited by the extent of the factorization.
  virtual BinarySvms withTau(double tau) const = 0;

  /// In descending order, the values of tau, 0..1, at which each vector is dropped: withTau(t)
  /// keeps vectors with larger values than t. For method qr, of all machines together. Empty for
  /// method none.
  virtual std::vector<double> thresholds() const = 0;
};

/// The methods that leave vectors out, in the order of the table above.
constexpr const char* kReductionMethods[] = {"qr", "shared-qr", "shared-greedy"};

/// Factorizes as far as `options`, whose method is not auto, require. `kernel_values` is the n x m
/// matrix K of eq. 6.19: K(y_i, x_j) of n training vectors and the m vectors of `machines`.
std::unique_ptr<const Reduction> factorize(const BinarySvms& machines,
                                           const Eigen::MatrixXd& kernel_values,
                                           const ReductionOptions& options,
                                           const Progress& progress = {});

/// The reduced machines that `options` request; never more vectors than before.
BinarySvms reduce(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                  const ReductionOptions& options, const Progress& progress = {});

/// The same for several options. Consecutive options that differ only in the number of vectors, in
/// descending order, share one factorization; different methods run in parallel.
std::vector<BinarySvms> reduceEach(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                                   const std::vector<ReductionOptions>& variants, unsigned threads);

/// Maximum number of the support vectors of `machines` that the options keep; all of them if tau
/// decides.
int vectorLimit(const ReductionOptions& options, const BinarySvms& machines);

}  // namespace place_recognition
