#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/huge_pages.h"
#include "learning/kernel_type.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// Vectors stored by bin, for comparing a new vector with all of them: for each bin of any vector,
/// in ascending order, the vectors that have it and their values. Memory and model files use the
/// same layout. A common bin, which at least half of the vectors have, is stored as a row of
/// values, one per vector, zero for vectors without it. A rare bin is stored as one posting per
/// vector that has it. Each is the faster representation of its kind of bin, and roughly the
/// smaller one.
struct PostingLists {
  static constexpr std::size_t kMaxVectors = 65536;  ///< limit of 16-bit numbers

  std::size_t dimension = 0;          ///< of dense vectors; 0: the vectors are sparse
  std::vector<double> totals;         ///< total() of each vector
  std::vector<std::uint64_t> bins;    ///< their indices, ascending
  std::vector<std::uint32_t> counts;  ///< number of vectors that have each bin; at least one
  HugeVector<float> rows;             ///< of the common bins, one after another
  HugeVector<float> values;           ///< of the rare bins' postings; not zero
  HugeVector<std::uint16_t> numbers;  ///< vector of each posting; ascending in each bin

  std::size_t vectors() const { return totals.size(); }
  bool isCommon(std::uint32_t count) const { return 2 * std::size_t{count} >= vectors(); }

  /// Throws Error, a phrase without a source, unless postingLists() can have made this from vectors
  /// of finite elements. Does not check that the totals match.
  void check() const;
};

/// The total that a measure needs of each vector alone: its sum for chi-squared, otherwise the sum
/// of its squares; in double precision, in ascending order of bins.
double total(Measure measure, const SparseVector& x);

/// Lays out `vectors` (sparse, or dense of one dimension) by bin. Throws Error if there are more
/// than kMaxVectors or if they are of several kinds.
PostingLists postingLists(Measure measure, const std::vector<Feature>& vectors);

/// Restores the vectors as they were given.
std::vector<Feature> vectorsOf(const PostingLists& lists);

/// Returns `x` itself, or its non-zero elements in `scratch`. Throws Error if it is neither a
/// sparse vector (`dimension` 0) nor a dense one of this dimension.
const SparseVector& asSparse(const Feature& x, std::size_t dimension, SparseVector& scratch);

}  // namespace place_recognition
