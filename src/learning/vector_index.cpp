#include "learning/vector_index.h"

#include <algorithm>

#include "base/simd.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// BinTable::Slot::count of a bin whose values are a row.
constexpr std::uint32_t kRow = 0xFFFFFFFF;
/// A bin that at least one vector in kRowShare has is kept as a row: an element of a row costs less
/// than a posting, in time and in memory, but also stands for the vectors that lack the bin.
constexpr std::size_t kRowShare = 3;
/// The memory is asked for what stands so many bins ahead; visiting it is what takes the time.
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

/// Asks the memory for the postings of a bin, or as much of a long row as the processor does not
/// foresee by itself.
PLACE_RECOGNITION_INLINE void prefetch(const VectorIndex::Postings& bin) {
  constexpr std::size_t kLine = 64 / sizeof(float);
  const std::size_t count = std::min<std::size_t>(bin.count, 2048);
  for (std::size_t i = 0; i < count; i += kLine) {
    __builtin_prefetch(bin.values + i);
    if (bin.vectors) __builtin_prefetch(bin.vectors + i);
  }
}

/// sums[v] += term(x, value of v) for every posting of every bin.
template <typename Term>
PLACE_RECOGNITION_INLINE void addTerms(const std::vector<VectorIndex::Postings>& bins, Term term,
                                       double* sums) {
  constexpr std::size_t kChunk = 64;
  double terms[kChunk];
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (b + kPostingsAhead < bins.size()) prefetch(bins[b + kPostingsAhead]);
    const VectorIndex::Postings& bin = bins[b];
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
void addProducts(const std::vector<VectorIndex::Postings>& bins, double* sums) {
  addTerms(bins, ProductTerm(), sums);
}

PLACE_RECOGNITION_TARGET_CLONES
void addChiSquared(const std::vector<VectorIndex::Postings>& bins, double* sums) {
  addTerms(bins, ChiSquaredTerm(), sums);
}

PLACE_RECOGNITION_TARGET_CLONES
void addMinima(const std::vector<VectorIndex::Postings>& bins, double* sums) {
  addTerms(bins, MinimumTerm(), sums);
}

}  // namespace

VectorIndex::VectorIndex(Measure measure, const std::vector<Feature>& vectors) : measure_(measure) {
  if (vectors.empty()) return;
  kind_ = vectors.front().index();
  if (const auto* dense = std::get_if<DenseVector>(&vectors.front())) {
    dimension_ = dense->values.size();
  }
  std::vector<SparseVector> converted(dimension_ > 0 ? vectors.size() : 0);
  SparseVector none;
  std::vector<const SparseVector*> sparse;
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    sparse.push_back(&asSparse(vectors[v], converted.empty() ? none : converted[v]));
    totals_.push_back(total(*sparse.back()));
  }
  collect(BinSlices(std::move(sparse)));
}

void VectorIndex::collect(BinSlices slices) {
  values_.reserve(slices.elements());
  vectors_.reserve(slices.elements());
  std::vector<BinTable::Slot> all;
  BinTable numbers;  // of the slice's bins, in the order in which they are met
  std::vector<BinTable::Slot> bins;
  std::vector<std::uint32_t> met;
  while (slices.next()) {
    numbers.clear();
    bins.clear();
    met.clear();
    slices.forEach([&](std::size_t, std::uint64_t bin, float) {
      BinTable::Slot& number = numbers.insert(bin);
      if (number.count++ == 0) {
        number.begin = static_cast<std::uint32_t>(bins.size());
        bins.push_back({bin, 0, 0});
      }
      ++bins[number.begin].count;
      met.push_back(number.begin);
    });
    layOut(bins);
    all.insert(all.end(), bins.begin(), bins.end());
    auto number = met.begin();
    slices.forEach([&](std::size_t v, std::uint64_t, float value) {
      BinTable::Slot& place = bins[*number++];
      if (place.count == kRow) {
        rows_[place.begin * totals_.size() + v] = value;
      } else {
        values_[place.begin] = value;
        vectors_[place.begin++] = static_cast<std::uint32_t>(v);
      }
    });
  }
  table_.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    table_.prefetch(all[std::min(i + kLookupsAhead, all.size() - 1)].bin);
    table_.insert(all[i].bin) = all[i];
  }
}

void VectorIndex::layOut(std::vector<BinTable::Slot>& bins) {
  std::size_t postings = values_.size();
  std::size_t rows = rows_.size() / totals_.size();
  for (BinTable::Slot& bin : bins) {
    if (bin.count * kRowShare >= totals_.size()) {
      bin.begin = static_cast<std::uint32_t>(rows++);
      bin.count = kRow;
    } else {
      bin.begin = static_cast<std::uint32_t>(postings);
      postings += bin.count;
    }
  }
  rows_.resize(rows * totals_.size());
  values_.resize(postings);
  vectors_.resize(postings);
}

const SparseVector& VectorIndex::asSparse(const Feature& x, SparseVector& scratch) const {
  if (x.index() != kind_) {
    throw Error("Cannot compare features of two kinds; extract both with the same options.");
  }
  if (const auto* sparse = std::get_if<SparseVector>(&x)) return *sparse;
  const std::vector<float>& values = std::get<DenseVector>(x).values;
  if (values.size() != dimension_) {
    throw Error("Cannot compare a vector of " + std::to_string(values.size()) +
                " elements with vectors of " + std::to_string(dimension_) +
                "; extract both with the same options.");
  }
  scratch.indices.clear();
  scratch.values.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0) continue;
    scratch.indices.push_back(i);
    scratch.values.push_back(values[i]);
  }
  return scratch;
}

double VectorIndex::total(const SparseVector& x) const {
  double sum = 0;
  if (measure_ == Measure::kChiSquared) {
    for (const double value : x.values) sum += value;
  } else if (measure_ == Measure::kSquaredDistance) {
    for (const double value : x.values) sum += value * value;
  }
  return sum;
}

std::vector<VectorIndex::Postings> VectorIndex::postingsOf(const SparseVector& x) const {
  std::vector<Postings> bins;
  bins.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    table_.prefetch(x.indices[std::min(i + kLookupsAhead, x.size() - 1)]);
    const BinTable::Slot& slot = table_.find(x.indices[i]);
    if (slot.count == kRow) {
      bins.push_back({&rows_[slot.begin * totals_.size()], nullptr, totals_.size(), x.values[i]});
    } else if (slot.count != 0) {
      bins.push_back({&values_[slot.begin], &vectors_[slot.begin], slot.count, x.values[i]});
    }
  }
  return bins;
}

void VectorIndex::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  if (totals_.empty()) return;
  SparseVector scratch;
  const SparseVector& sparse = asSparse(x, scratch);
  const std::vector<Postings> bins = postingsOf(sparse);
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
  // What rounding leaves of the distance of equal vectors must not become negative.
  const double shared_weight = measure_ == Measure::kChiSquared ? 4 : 2;
  const Eigen::Map<const Eigen::VectorXd> totals(totals_.data(), out.size());
  out = (total(sparse) + totals.array() - shared_weight * out.array()).max(0).matrix();
}

}  // namespace place_recognition
