#pragma once

#include <Eigen/Core>

#include "place_recognition/feature.h"

namespace place_recognition {

/// A memory layout of support vectors that one feature is compared with all at once.
class SupportIndex {
 public:
  virtual ~SupportIndex() = default;

  /// Kernel::measure(x, vector i) for the first vectors, as many as `out` has elements. Throws
  /// Error if `x` is of another kind or dimension than the vectors. Safe to call from several
  /// threads.
  virtual void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const = 0;
};

}  // namespace place_recognition
