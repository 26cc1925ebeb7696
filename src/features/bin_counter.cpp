#include "features/bin_counter.h"

#include <algorithm>

namespace place_recognition {
namespace {

constexpr int kInitialBits = 14;

}  // namespace

BinCounter::BinCounter() : slots_(std::size_t{1} << kInitialBits), shift_(64 - kInitialBits) {}

void BinCounter::clear() {
  std::fill(slots_.begin(), slots_.end(), Slot{0, 0});
  used_ = 0;
}

std::size_t BinCounter::firstSlot(std::uint64_t bin) const {
  return (bin * 0x9e3779b97f4a7c15u) >> shift_;  // Fibonacci hashing: 2^64 / golden ratio.
}

BinCounter::Slot& BinCounter::slotOf(std::uint64_t bin) {
  std::size_t i = firstSlot(bin);
  while (slots_[i].count > 0 && slots_[i].bin != bin) i = (i + 1) & (slots_.size() - 1);
  return slots_[i];
}

void BinCounter::add(const std::uint64_t* bins, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    Slot& slot = slotOf(bins[i]);
    if (slot.count++ == 0) {
      slot.bin = bins[i];
      if (2 * ++used_ > slots_.size()) grow();
    }
  }
}

void BinCounter::grow() {
  std::vector<Slot> old(2 * slots_.size());
  old.swap(slots_);
  --shift_;
  for (const Slot& slot : old) {
    if (slot.count > 0) slotOf(slot.bin) = slot;
  }
}

void BinCounter::histogram(double total, SparseVector& result) {
  sorted_.clear();
  for (const Slot& slot : slots_) {
    if (slot.count > 0) sorted_.push_back(slot);
  }
  std::sort(sorted_.begin(), sorted_.end(),
            [](const Slot& a, const Slot& b) { return a.bin < b.bin; });
  result.indices.resize(sorted_.size());
  result.values.resize(sorted_.size());
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    result.indices[i] = sorted_[i].bin;
    result.values[i] = static_cast<float>(sorted_[i].count / total);
  }
}

}  // namespace place_recognition
