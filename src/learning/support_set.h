#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "learning/inverted_index.h"
#include "learning/kernel.h"
#include "learning/local_match_index.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// The vectors that all machines of a classifier share, laid out for comparing a new feature with
/// all of them at once (vectors: an inverted index; local descriptors: blocked products).
/// Immutable; safe to share between threads.
class SupportSet {
 public:
  using Index = std::variant<InvertedIndex, LocalMatchIndex>;

  /// Throws Error unless all features are of one kind (and not missing) for which the kernel is
  /// defined. There may be no vectors.
  SupportSet(const Kernel& kernel, const std::vector<Feature>& vectors);
  /// Uses vectors that are already laid out; see InvertedIndex.
  SupportSet(const Kernel& kernel, PostingLists lists);

  /// Computes kernel.measure(x, vector i) for the first vectors, as many as `out` has elements.
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;
  /// Computes kernel(x, vector i), likewise.
  void kernelValues(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;

  std::size_t size() const;
  /// Restores the vectors as they were given; takes as long as laying them out.
  std::vector<Feature> vectors() const;
  const Index& index() const { return index_; }
  const Kernel& kernel() const { return kernel_; }

 private:
  Kernel kernel_;
  Index index_;
};

}  // namespace place_recognition
