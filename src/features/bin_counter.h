#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "place_recognition/feature.h"

namespace place_recognition {

/// Counts how often each bin of a histogram of up to 2^64 bins is hit, keeping only the bins that
/// are: an open-addressing hash table, small enough for the processor's cache, that grows with
/// them.
class BinCounter {
 public:
  BinCounter();

  void clear();
  /// Counts `n` more hits.
  void add(const std::uint64_t* bins, std::size_t n);
  /// The bins that were hit, ascending, each with its count divided by `total`.
  void histogram(double total, SparseVector& result);

 private:
  struct Slot {
    std::uint64_t bin;
    std::uint32_t count;  ///< 0: the slot is free.
  };

  std::size_t firstSlot(std::uint64_t bin) const;
  Slot& slotOf(std::uint64_t bin);
  void grow();

  std::vector<Slot> slots_;  ///< A power of two, at most half of them in use.
  int shift_;                ///< 64 - log2 of their number.
  std::size_t used_ = 0;
  std::vector<Slot> sorted_;
};

}  // namespace place_recognition
