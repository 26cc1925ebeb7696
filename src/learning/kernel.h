#pragma once

#include "learning/kernel_type.h"
#include "learning/posting_lists.h"
#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// A kernel function (thesis section 5.2.2) in two steps, so that a matrix of the costly part can
/// be reused while gamma is searched: measure(x, y), then value(measure).
///
/// | type         | measure(x, y)                          | value(m)            | Mercer |
/// | linear       | x'y                                    | m                   | yes    |
/// | polynomial   | x'y                                    | (m + p)^d           | p >= 0 |
/// | sigmoid      | x'y                                    | tanh(kappa m+theta) | no     |
/// | intersection | sum min(x_i, y_i)                      | m                   | yes    |
/// | gaussian     | |x - y|^2                              | exp(-gamma m)       | yes    |
/// | chi-squared  | sum (x_i - y_i)^2 / (x_i + y_i)        | exp(-gamma m)       | yes    |
/// | local-match  | (eq. 5.39-5.40, K_l Gaussian of gamma) | m                   | no     |
///
/// Descriptors of a DescriptorSet are taken in units of 512 (SIFT's own scale), so that gamma means
/// the same as for vectors of norm one. Immutable; safe to share between threads.
class Kernel {
 public:
  /// Throws Error if the options do not check.
  explicit Kernel(const KernelOptions& options);

  /// The plain definition, in double precision; the reference for every faster way. Throws Error if
  /// the two features differ in kind or dimension, or the kernel has no meaning for that kind.
  double measure(const Feature& x, const Feature& y) const;
  double value(double measure) const;
  double operator()(const Feature& x, const Feature& y) const { return value(measure(x, y)); }

  /// Throws Error, listing the kernels that do, if this kernel has no meaning for `feature`: sets
  /// of descriptors have local-match, vectors the others; chi-squared and intersection take
  /// histograms, without negative elements.
  void requireMeaningFor(const Feature& feature) const;
  /// Likewise, for vectors bin by bin.
  void requireMeaningFor(const PostingLists& lists) const;

  /// Whether measure() is free of gamma, so that one matrix of measures serves every gamma.
  bool measureIsFreeOfGamma() const;

  const KernelOptions& options() const { return options_; }
  const KernelType& type() const { return type_; }

 private:
  void requireMeaningFor(bool descriptors, bool negative_elements) const;

  KernelOptions options_;
  KernelType type_;
};

}  // namespace place_recognition
