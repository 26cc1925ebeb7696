#pragma once

#include <cstdint>
#include <vector>

#include "base/huge_pages.h"
#include "learning/bin_table.h"
#include "learning/kernel_type.h"
#include "learning/support_index.h"

namespace place_recognition {

/// Sparse or dense vectors as an inverted index: bin -> the vectors that have it, and their values.
/// All measures of vectors are sums over the bins that both vectors have (of xy, xy/(x+y) or
/// min(x, y)) and totals of each vector alone, for example
/// chi2(x, y) = sum x + sum y - 4 sum_shared xy/(x+y); so one pass over the bins of x serves every
/// support vector. Terms and sums are in double precision, in ascending order of bins.
class VectorIndex : public SupportIndex {
 public:
  VectorIndex(Measure measure, const std::vector<Feature>& vectors);
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const override;

  /// The values of one bin: either `count` pairs of (value, vector), or, in a bin that many vectors
  /// have, a whole row of values, one a vector.
  struct Postings {
    const float* values;
    const std::uint32_t* vectors;  ///< null: a row
    std::size_t count;
    double x;  ///< of the new vector, in this bin
  };

 private:
  /// `x` itself, or its non-zero elements in `scratch`; Error if it is of a foreign kind.
  const SparseVector& asSparse(const Feature& x, SparseVector& scratch) const;
  double total(const SparseVector& x) const;
  /// Gives every bin, counted in the table, its place in values_ or rows_.
  void layOut();
  /// Of the bins of `x`, of the first `vectors` vectors.
  std::vector<Postings> postingsOf(const SparseVector& x, std::size_t vectors) const;

  Measure measure_;
  std::size_t kind_ = 0;        ///< index of the alternative of Feature
  std::size_t dimension_ = 0;   ///< of dense vectors
  std::vector<double> totals_;  ///< one a vector
  BinTable table_;
  std::vector<float, HugePages<float>> values_;
  std::vector<std::uint32_t, HugePages<std::uint32_t>> vectors_;
  std::vector<float, HugePages<float>> rows_;  ///< as many elements a row as vectors
};

}  // namespace place_recognition
