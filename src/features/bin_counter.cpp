#include "features/bin_counter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace place_recognition {
namespace {

constexpr int kInitialBits = 14;
constexpr std::size_t kSlotsPerEntry = 4;  // At least; collisions and mispredictions are rare.
constexpr std::uint64_t kNoBin = ~std::uint64_t{0};

/// Radix sort of entries by bin, several times faster than a comparison sort.
template <typename Entry>
void radixSort(std::vector<Entry>& entries, std::vector<Entry>& scratch) {
  constexpr int kDigitBits = 10;
  constexpr int kPlaces = (64 + kDigitBits - 1) / kDigitBits;
  constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
  const auto digit = [](const Entry& entry, int place) {
    return (entry.bin >> place * kDigitBits) % kDigits;
  };
  // Position for the next entry, by digit and place.
  std::array<std::array<std::uint32_t, kDigits>, kPlaces> next{};
  for (const Entry& entry : entries) {
    for (int place = 0; place < kPlaces; ++place) ++next[place][digit(entry, place)];
  }
  scratch.resize(entries.size());
  for (int place = 0; place < kPlaces; ++place) {
    std::uint32_t before = 0;
    for (std::uint32_t& count : next[place]) before += std::exchange(count, before);
    if (next[place][1] == entries.size()) continue;  // all have digit 0
    for (const Entry& entry : entries) scratch[next[place][digit(entry, place)]++] = entry;
    entries.swap(scratch);
  }
}

}  // namespace

BinCounter::BinCounter() : table_(std::size_t{1} << kInitialBits), shift_(64 - kInitialBits) {
  clear();
}

void BinCounter::clear() {
  entries_.assign(1, {kNoBin, 0});
  std::fill(table_.begin(), table_.end(), 0);
}

inline std::size_t BinCounter::hash(std::uint64_t bin) const {
  return (bin * 0x9e3779b97f4a7c15u) >> shift_;  // Fibonacci hashing: 2^64 / golden ratio.
}

void BinCounter::add(const std::uint64_t* bins, std::size_t n) {
  // Whether a bin is found at its first slot is unpredictable, so the first pass has no branches;
  // bins that are new or in later slots follow in a second pass.
  missed_.resize(n);
  std::size_t missed = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Entry& entry = entries_[table_[hash(bins[i])]];
    const bool found = entry.bin == bins[i];
    entry.count += found;
    missed_[missed] = bins[i];
    missed += !found;
  }
  for (std::size_t i = 0; i < missed; ++i) ++findOrInsert(missed_[i]).count;
}

BinCounter::Entry& BinCounter::findOrInsert(std::uint64_t bin) {
  assert(bin != kNoBin);
  std::size_t slot = hash(bin);
  for (; table_[slot] != 0; slot = (slot + 1) & (table_.size() - 1)) {
    Entry& entry = entries_[table_[slot]];
    if (entry.bin == bin) return entry;
  }
  table_[slot] = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back({bin, 0});
  if (entries_.size() * kSlotsPerEntry > table_.size()) grow();
  return entries_.back();
}

void BinCounter::grow() {
  table_.assign(2 * table_.size(), 0);
  --shift_;
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    std::size_t slot = hash(entries_[i].bin);
    while (table_[slot] != 0) slot = (slot + 1) & (table_.size() - 1);
    table_[slot] = static_cast<std::uint32_t>(i);
  }
}

void BinCounter::histogram(double total, SparseVector& result) {
  sorted_.assign(entries_.begin() + 1, entries_.end());
  radixSort(sorted_, scratch_);
  result.indices.resize(sorted_.size());
  result.values.resize(sorted_.size());
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    result.indices[i] = sorted_[i].bin;
    result.values[i] = static_cast<float>(static_cast<double>(sorted_[i].count) / total);
  }
}

}  // namespace place_recognition
