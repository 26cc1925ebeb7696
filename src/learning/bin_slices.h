#pragma once

#include <cstdint>
#include <vector>

#include "place_recognition/feature.h"

namespace place_recognition {

/// Walks through sparse vectors by slices of bins instead of vector by vector: all elements of the
/// lowest bins, of one vector after the other, then those of the next bins. What is collected about
/// the bins of a slice fits the second-level cache, where that about all bins would not.
class BinSlices {
 public:
  /// Of vectors that stay where they are.
  explicit BinSlices(std::vector<const SparseVector*> vectors);

  /// Goes to the next slice, at first the first; false behind the last.
  bool next();

  /// Calls visit(v, bin, value) for each element of the slice: v ascends, and so do the bins of v.
  template <typename Visit>
  void forEach(Visit visit) const {
    for (std::size_t v = 0; v < vectors_.size(); ++v) {
      const SparseVector& vector = *vectors_[v];
      for (std::size_t i = begin_[v]; i < end_[v]; ++i)
        visit(v, vector.indices[i], vector.values[i]);
    }
  }

  /// Elements of all slices.
  std::size_t elements() const { return elements_; }

 private:
  std::vector<const SparseVector*> vectors_;
  std::size_t elements_ = 0;
  std::vector<std::uint64_t> bounds_;     ///< the first bin behind each slice but the last
  std::size_t slice_ = 0;                 ///< number of slices visited
  std::vector<std::size_t> begin_, end_;  ///< the slice's part of each vector
};

}  // namespace place_recognition
