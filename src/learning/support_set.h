#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "learning/kernel.h"
#include "learning/support_index.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// The vectors that all machines of a classifier share, laid out for comparing one new feature with
/// all of them at once (vectors: an inverted index, bin -> postings; local descriptors: blocked
/// products). Immutable; safe to share between threads.
class SupportSet {
 public:
  /// All features must be of one kind (and not missing) that the kernel has a meaning for, else
  /// Error. May be empty.
  SupportSet(const Kernel& kernel, std::vector<Feature> vectors);

  /// kernel.measure(x, vector i) for the first vectors, as many as `out` has elements.
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;
  /// kernel(x, vector i), likewise.
  void kernelValues(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;

  std::size_t size() const { return vectors_.size(); }
  const std::vector<Feature>& vectors() const { return vectors_; }
  const Kernel& kernel() const { return kernel_; }

 private:
  Kernel kernel_;
  std::vector<Feature> vectors_;
  std::unique_ptr<SupportIndex> index_;
};

}  // namespace place_recognition
