#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/huge_pages.h"
#include "learning/vector_index.h"

namespace place_recognition {

/// The vectors of an index compared with each other: the lower triangle of their matrix of
/// measures, row by row. What a vector shares with those before it is read off the index once, so
/// that no bin is looked up, which would be a quarter of the work. Immutable.
class VectorTriangle {
 public:
  /// `index` must outlive this.
  explicit VectorTriangle(const VectorIndex& index);

  /// Kernel::measure(vector v, vector i) for i = 0..v, the elements of `out`; the same bits as
  /// VectorIndex::measures().
  void measures(std::size_t v, Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  /// One of a vector's elements: of the bin's postings those up to the vector's own.
  struct Element {
    std::uint32_t begin;  ///< first posting or, for a common bin, the row
    std::uint32_t count;  ///< of postings; 0: a row
    float value;
  };

  const VectorIndex& index_;
  HugeVector<Element> elements_;     ///< of each vector in ascending order of bins
  std::vector<std::size_t> begins_;  ///< of each vector, and the end of the last
};

}  // namespace place_recognition
