#pragma once

#include "learning/kernel_type.h"
#include "learning/posting_lists.h"
#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// A kernel function (thesis section 5.2.2) in two steps: measure(x, y), then value(measure). A
/// matrix of the expensive measures can thus be reused while gamma is searched.
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
/// Descriptors of a DescriptorSet are used in units of 512 (SIFT's own scale), so that gamma means
/// the same as for vectors of norm one. Immutable; safe to share between threads.
class Kernel {
 public:
  /// Throws Error if an option is out of range.
  explicit Kernel(const KernelOptions& options);

  /// The plain definition, in double precision; the reference for all faster implementations.
  /// Throws Error if the two features differ in kind or dimension, or if the kernel is not defined
  /// for that kind.
  double measure(const Feature& x, const Feature& y) const;
  double value(double measure) const;
  double operator()(const Feature& x, const Feature& y) const { return value(measure(x, y)); }

  /// Throws Error, listing the suitable kernels, if this kernel is not defined for `feature`:
  /// local-match is defined for sets of descriptors, the others for vectors; chi-squared and
  /// intersection require histograms, that is, no negative elements.
  void requireMeaningFor(const Feature& feature) const;
  /// The same for vectors in posting lists.
  void requireMeaningFor(const PostingLists& lists) const;

  /// Whether measure() is independent of gamma, so that one matrix of measures serves every gamma.
  bool measureIsFreeOfGamma() const;

  const KernelOptions& options() const { return options_; }
  const KernelType& type() const { return type_; }

 private:
  void requireMeaningFor(bool descriptors, bool negative_elements) const;

  KernelOptions options_;
  KernelType type_;
};

}  // namespace place_recognition
