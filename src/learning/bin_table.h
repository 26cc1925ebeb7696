#pragma once

#include <cstddef>
#include <cstdint>

#include "base/huge_pages.h"

namespace place_recognition {

/// Position of the values of each bin of a support set: an open-addressing hash table of 16-byte
/// slots, so that looking up a bin touches one cache line.
class BinTable {
 public:
  struct Slot {
    std::uint64_t bin = 0;
    std::uint32_t begin = 0;
    std::uint32_t count = 0;  ///< 0: the slot is empty
  };

  using Slots = HugeVector<Slot>;

  /// Reserves room for `bins` bins; the table grows if there are more.
  explicit BinTable(std::size_t bins = 0) : bits_(bitsFor(bins)), slots_(std::size_t{1} << bits_) {}

  /// The slot of `bin`, with a count of 0 if it is new; the caller must then increase the count.
  /// Invalidates references from earlier calls.
  Slot& insert(std::uint64_t bin) {
    if (2 * used_ >= slots_.size()) grow();
    Slot& slot = slots_[position(bin)];
    if (slot.count == 0) {
      ++used_;
      slot.bin = bin;
    }
    return slot;
  }

  /// The slot of `bin`, or one with a count of 0.
  const Slot& find(std::uint64_t bin) const { return slots_[position(bin)]; }
  Slot& find(std::uint64_t bin) { return slots_[position(bin)]; }

  /// Prefetches the memory that find(bin) will read.
  void prefetch(std::uint64_t bin) const { __builtin_prefetch(&slots_[home(bin)]); }

  Slots& slots() { return slots_; }

 private:
  static unsigned bitsFor(std::size_t bins) {
    unsigned bits = 10;
    while (2 * bins > std::size_t{1} << bits) ++bits;
    return bits;
  }

  /// Fibonacci hashing: the high bits of a product with 2^64 / golden ratio.
  std::size_t home(std::uint64_t bin) const { return (bin * 0x9E3779B97F4A7C15u) >> (64 - bits_); }

  std::size_t position(std::uint64_t bin) const {
    std::size_t i = home(bin);
    while (slots_[i].count != 0 && slots_[i].bin != bin) i = (i + 1) & (slots_.size() - 1);
    return i;
  }

  void grow() {
    Slots old(2 * slots_.size());
    old.swap(slots_);
    ++bits_;
    for (const Slot& slot : old) {
      if (slot.count != 0) slots_[position(slot.bin)] = slot;
    }
  }

  unsigned bits_;  ///< log2 of the number of slots
  Slots slots_;
  std::size_t used_ = 0;
};

}  // namespace place_recognition
