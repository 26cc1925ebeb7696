#include "learning/inverted_index.h"

#include <algorithm>
#include <cassert>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// BinTable::Slot::count of a bin that is stored as a row.
constexpr std::uint32_t kRow = 0xFFFFFFFF;
/// Number of bins by which memory is prefetched in advance; accessing it takes most of the time.
constexpr std::size_t kLookupsAhead = 8;
constexpr std::size_t kPostingsAhead = 3;

struct ProductTerm {
  PLACE_RECOGNITION_INLINE double operator()(double x, double y) const { return x * y; }
};
struct ChiSquaredTerm {
  PLACE_RECOGNITION_INLINE double operator()(double x, double y) const { return x * y / (x + y); }
};
struct MinimumTerm {
  PLACE_RECOGNITION_INLINE double operator()(double x, double y) const { return x < y ? x : y; }
};

/// Prefetches all values of a bin.
PLACE_RECOGNITION_INLINE void prefetch(const InvertedIndex::Postings& bin) {
  constexpr std::size_t kLine = 64 / sizeof(float);
  for (std::size_t i = 0; i < bin.count; i += kLine) {
    __builtin_prefetch(bin.values + i);
    if (bin.vectors) __builtin_prefetch(bin.vectors + i);
  }
}

/// sums[v] += term(x, value of v) for every posting of every bin.
template <typename Term>
PLACE_RECOGNITION_INLINE void addTerms(const std::vector<InvertedIndex::Postings>& bins, Term term,
                                       double* sums) {
  constexpr std::size_t kChunk = 64;
  double terms[kChunk];
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (b + kPostingsAhead < bins.size()) prefetch(bins[b + kPostingsAhead]);
    const InvertedIndex::Postings& bin = bins[b];
    if (!bin.vectors) {
      for (std::size_t i = 0; i < bin.count; ++i) sums[i] += term(bin.x, bin.values[i]);
      continue;
    }
    for (std::size_t begin = 0; begin < bin.count; begin += kChunk) {
      const std::size_t n = std::min(kChunk, bin.count - begin);
      for (std::size_t i = 0; i < n; ++i) terms[i] = term(bin.x, bin.values[begin + i]);
      for (std::size_t i = 0; i < n; ++i) sums[bin.vectors[begin + i]] += terms[i];
    }
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void addProducts(const std::vector<InvertedIndex::Postings>& bins, double* sums) {
  addTerms(bins, ProductTerm(), sums);
}

PLACE_RECOGNITION_TARGET_CLONES
void addChiSquared(const std::vector<InvertedIndex::Postings>& bins, double* sums) {
  addTerms(bins, ChiSquaredTerm(), sums);
}

PLACE_RECOGNITION_TARGET_CLONES
void addMinima(const std::vector<InvertedIndex::Postings>& bins, double* sums) {
  addTerms(bins, MinimumTerm(), sums);
}

}  // namespace

InvertedIndex::InvertedIndex(Measure measure, PostingLists lists)
    : measure_(measure), lists_(std::move(lists)) {
  lists_.check();
  const std::vector<std::uint64_t>& bins = lists_.bins;
  table_ = BinTable(bins.size());
  std::uint32_t rows = 0;
  std::uint32_t postings = 0;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    table_.prefetch(bins[std::min(b + kLookupsAhead, bins.size() - 1)]);
    const std::uint32_t count = lists_.counts[b];
    const bool common = lists_.isCommon(count);
    BinTable::Slot& slot = table_.insert(bins[b]);
    slot.count = common ? kRow : count;
    slot.begin = common ? rows++ : postings;
    postings += common ? 0 : count;
  }
}

InvertedIndex::Postings InvertedIndex::postingsAt(const BinTable::Slot& slot, double x,
                                                  std::size_t vectors) const {
  if (slot.count == kRow) return {&lists_.rows[slot.begin * size()], nullptr, vectors, x};
  const std::uint16_t* const numbers = &lists_.numbers[slot.begin];
  const std::size_t count =
      vectors == size() ? slot.count
                        : static_cast<std::size_t>(
                              std::lower_bound(numbers, numbers + slot.count, vectors) - numbers);
  return {&lists_.values[slot.begin], numbers, count, x};
}

std::vector<InvertedIndex::Postings> InvertedIndex::postingsOf(const SparseVector& x,
                                                               std::size_t vectors) const {
  std::vector<Postings> bins;
  bins.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    table_.prefetch(x.indices[std::min(i + kLookupsAhead, x.size() - 1)]);
    const BinTable::Slot& slot = table_.find(x.indices[i]);
    if (slot.count != 0) bins.push_back(postingsAt(slot, x.values[i], vectors));
  }
  return bins;
}

void InvertedIndex::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  const auto vectors = static_cast<std::size_t>(out.size());
  assert(vectors <= size());
  if (vectors == 0) return;
  SparseVector scratch;
  const SparseVector& sparse = asSparse(x, lists_.dimension, scratch);
  const std::vector<Postings> bins = postingsOf(sparse, vectors);
  out.setZero();
  switch (measure_) {
    case Measure::kChiSquared:
      addChiSquared(bins, out.data());
      break;
    case Measure::kIntersection:
      addMinima(bins, out.data());
      break;
    default:
      addProducts(bins, out.data());
  }
  if (measure_ != Measure::kChiSquared && measure_ != Measure::kSquaredDistance) return;
  // Rounding must not make the distance of equal vectors negative.
  const double shared_weight = measure_ == Measure::kChiSquared ? 4 : 2;
  const Eigen::Map<const Eigen::VectorXd> totals(lists_.totals.data(), out.size());
  out = (total(measure_, sparse) + totals.array() - shared_weight * out.array()).max(0).matrix();
}

}  // namespace place_recognition
