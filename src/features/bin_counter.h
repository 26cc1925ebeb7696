#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "place_recognition/feature.h"

namespace place_recognition {

/// Counts the hits of each bin of a histogram with up to 2^64 - 1 bins. Only bins with hits are
/// stored, in the order of their first hit, and found through a small hash table, so that the
/// memory in use stays in the processor's cache. Grows with the number of bins hit.
class BinCounter {
 public:
  BinCounter();

  void clear();
  /// Counts `n` more hits; every bin is less than 2^64 - 1.
  void add(const std::uint64_t* bins, std::size_t n);
  /// The bins with hits, ascending, each with its count divided by `total`.
  void histogram(double total, SparseVector& result);

 private:
  struct Entry {
    std::uint64_t bin;
    std::uint64_t count;
  };

  std::size_t hash(std::uint64_t bin) const;
  Entry& findOrInsert(std::uint64_t bin);
  void grow();

  std::vector<Entry> entries_;        ///< The first entry stands for no bin.
  std::vector<std::uint32_t> table_;  ///< Index of the entry by hash; 0 if none. Open addressing.
  int shift_;                         ///< 64 - log2 of the size of the table.
  std::vector<std::uint64_t> missed_;
  std::vector<Entry> sorted_, scratch_;
};

}  // namespace place_recognition
