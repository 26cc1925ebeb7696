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
/// qr            each machine on its own support vectors; weights by eq. 6.21
/// shared-qr     pivoted QR of all columns once, one basis for all machines, weights refitted
/// shared-greedy basis grown one vector at a time so that all machines' decision values on the
/// training
///               vectors are reproduced best (orthogonal matching pursuit), weights refitted
/// none          the machines as they are
///
/// Every method chooses its vectors one after the other, so that a reduction to N vectors holds all
/// those to fewer. Immutable.
class Reduction {
 public:
  virtual ~Reduction() = default;

  /// Binary SVMs over the vectors of those reduced, where weights of at most `count` vectors are
  /// not zero: the same as with options that ask for `count`.
  virtual BinarySvms withVectors(int count) const = 0;

  /// The same with options that ask for `tau`, as far as the factorization goes.
  virtual BinarySvms withTau(double tau) const = 0;

  /// In descending order the values of tau, 0..1, that leave each vector out: withTau(t) keeps
  /// those of more than t. For method qr, of all machines together. Empty for method none.
  virtual std::vector<double> thresholds() const = 0;
};

/// Factorizes as far as `options`, whose method is not auto, ask for. `kernel_values` is the n x m
/// matrix K of eq. 6.19, K(y_i, x_j) of n training vectors and the m vectors of `machines`.
std::unique_ptr<const Reduction> factorize(const BinarySvms& machines,
                                           const Eigen::MatrixXd& kernel_values,
                                           const ReductionOptions& options,
                                           const Progress& progress = {});

/// The reduced machines that `options` ask for: never more vectors than before.
BinarySvms reduce(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                  const ReductionOptions& options, const Progress& progress = {});

/// The same for several options. Neighbours that differ only in the number of vectors, the one of
/// the most first, share one factorization; different methods run in parallel.
std::vector<BinarySvms> reduceEach(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                                   const std::vector<ReductionOptions>& variants, unsigned threads);

/// How many of the support vectors of `machines` the options keep at most; as many as there are
/// where tau decides.
int vectorLimit(const ReductionOptions& options, const BinarySvms& machines);

}  // namespace place_recognition
