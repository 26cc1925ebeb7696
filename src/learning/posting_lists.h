#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/huge_pages.h"
#include "learning/kernel_type.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// Vectors bin by bin, the way one new vector is compared with all of them: for each bin that any
/// of them has, in ascending order, who has it and with which value. Both in memory and in a model
/// file. In a common bin, which at least half of the vectors have, that is a row of values, one a
/// vector, zero for those that lack it; in a rare one it is a posting for each vector that has it.
/// Either takes the less time, and about the less memory.
struct PostingLists {
  static constexpr std::size_t kMaxVectors = 65536;  ///< what 16 bits can number

  std::size_t dimension = 0;          ///< of dense vectors; 0: the vectors are sparse
  std::vector<double> totals;         ///< total() of each vector
  std::vector<std::uint64_t> bins;    ///< their indices, ascending
  std::vector<std::uint32_t> counts;  ///< of the vectors that have each bin; at least one
  HugeVector<float> rows;             ///< of the common bins, one after the other
  HugeVector<float> values;           ///< of the rare bins' postings: not zero
  HugeVector<std::uint16_t> numbers;  ///< of the postings: of the vector; ascending in each bin

  std::size_t vectors() const { return totals.size(); }
  bool isCommon(std::uint32_t count) const { return 2 * std::size_t{count} >= vectors(); }

  /// Throws Error, a phrase without a source, unless this is what postingLists() makes of some
  /// vectors of finite elements; whether the totals are theirs is not looked at.
  void check() const;
};

/// What a measure has to know of each vector alone: its sum for chi-squared, else that of its
/// squares; in double precision, in ascending order of bins.
double total(Measure measure, const SparseVector& x);

/// `vectors` (sparse, or dense of one dimension) bin by bin. Throws Error if there are more than
/// kMaxVectors or if they are of several kinds.
PostingLists postingLists(Measure measure, const std::vector<Feature>& vectors);

/// The vectors again, as they were given.
std::vector<Feature> vectorsOf(const PostingLists& lists);

/// `x` itself, or its non-zero elements in `scratch`. Throws Error if it is not a sparse vector
/// (`dimension` 0) or a dense one of this dimension.
const SparseVector& asSparse(const Feature& x, std::size_t dimension, SparseVector& scratch);

}  // namespace place_recognition
