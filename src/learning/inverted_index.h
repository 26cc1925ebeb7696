#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "learning/bin_table.h"
#include "learning/kernel_type.h"
#include "learning/posting_lists.h"

namespace place_recognition {

/// Sparse or dense vectors as an inverted index: for each bin, the vectors that have it, and their
/// values. Every measure is a sum over the bins that both vectors have (of xy, xy/(x+y) or min(x,
/// y)) plus totals of each vector alone, for example chi2(x, y) = sum x + sum y - 4 sum_shared
/// xy/(x+y). One pass over the bins of x therefore serves all support vectors. Terms and sums are
/// in double precision, in ascending order of bins.
class InvertedIndex {
 public:
  /// Throws Error, a phrase without a source, if `lists` do not describe vectors of finite
  /// elements.
  InvertedIndex(Measure measure, PostingLists lists);

  /// Computes Kernel::measure(x, vector i) for the first vectors, as many as `out` has elements.
  /// Throws Error if `x` is of another kind or dimension than the vectors. Safe to call from
  /// several threads.
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;

  std::size_t size() const { return lists_.vectors(); }
  std::vector<Feature> vectors() const { return vectorsOf(lists_); }
  const PostingLists& lists() const { return lists_; }

  /// The values of one bin: either `count` pairs of (value, vector), or a row of values.
  struct Postings {
    const float* values;
    const std::uint16_t* vectors;  ///< null: a row
    std::size_t count;
    double x;  ///< of the new vector, in this bin
  };

 private:
  Postings postingsAt(const BinTable::Slot& slot, double x, std::size_t vectors) const;
  /// Those of the first `vectors` in the bins of `x`, ascending.
  std::vector<Postings> postingsOf(const SparseVector& x, std::size_t vectors) const;

  Measure measure_;
  PostingLists lists_;
  BinTable table_;  ///< position of each bin in the lists
};

}  // namespace place_recognition
