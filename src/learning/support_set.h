#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "learning/inverted_index.h"
#include "learning/kernel.h"
#include "learning/local_match_index.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// The vectors that all machines of a classifier share, laid out for comparing one new feature with
/// all of them at once (vectors: an inverted index, bin -> postings; local descriptors: blocked
/// products). Immutable; safe to share between threads.
class SupportSet {
 public:
  using Index = std::variant<InvertedIndex, LocalMatchIndex>;

  /// All features must be of one kind (and not missing) that the kernel has a meaning for, else
  /// Error. May be empty.
  SupportSet(const Kernel& kernel, const std::vector<Feature>& vectors);
  /// Vectors that are laid out already; see InvertedIndex.
  SupportSet(const Kernel& kernel, PostingLists lists);

  /// kernel.measure(x, vector i) for the first vectors, as many as `out` has elements.
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;
  /// kernel(x, vector i), likewise.
  void kernelValues(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;

  std::size_t size() const;
  /// The vectors as they were given, put together from the index; takes as long as laying them out.
  std::vector<Feature> vectors() const;
  const Index& index() const { return index_; }
  const Kernel& kernel() const { return kernel_; }

 private:
  Kernel kernel_;
  Index index_;
};

}  // namespace place_recognition
