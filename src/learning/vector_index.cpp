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
  SparseVector scratch;
  for (const Feature& vector : vectors) {
    const SparseVector& sparse = asSparse(vector, scratch);
    totals_.push_back(total(sparse));
    for (std::size_t i = 0; i < sparse.size(); ++i) {
      table_.prefetch(sparse.indices[std::min(i + kLookupsAhead, sparse.size() - 1)]);
      ++table_.insert(sparse.indices[i]).count;
    }
  }
  layOut();
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    const SparseVector& sparse = asSparse(vectors[v], scratch);
    for (std::size_t i = 0; i < sparse.size(); ++i) {
      table_.prefetch(sparse.indices[std::min(i + kLookupsAhead, sparse.size() - 1)]);
      BinTable::Slot& slot = table_.find(sparse.indices[i]);
      if (slot.count == kRow) {
        rows_[slot.begin * vectors.size() + v] = sparse.values[i];
      } else {
        values_[slot.begin] = sparse.values[i];
        vectors_[slot.begin++] = static_cast<std::uint32_t>(v);
      }
    }
  }
  for (BinTable::Slot& slot : table_.slots()) {
    if (slot.count != kRow) slot.begin -= slot.count;
  }
}

void VectorIndex::layOut() {
  std::uint32_t postings = 0;
  std::uint32_t rows = 0;
  for (BinTable::Slot& slot : table_.slots()) {
    if (slot.count == 0) continue;
    if (slot.count * kRowShare >= totals_.size()) {
      slot.begin = rows++;
      slot.count = kRow;
    } else {
      slot.begin = postings;
      postings += slot.count;
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

std::vector<VectorIndex::Postings> VectorIndex::postingsOf(const SparseVector& x,
                                                           std::size_t vectors) const {
  std::vector<Postings> bins;
  bins.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    table_.prefetch(x.indices[std::min(i + kLookupsAhead, x.size() - 1)]);
    const BinTable::Slot& slot = table_.find(x.indices[i]);
    if (slot.count == kRow) {
      bins.push_back({&rows_[slot.begin * totals_.size()], nullptr, vectors, x.values[i]});
    } else if (slot.count != 0) {
      const std::uint32_t* first = &vectors_[slot.begin];
      std::size_t count = slot.count;  // in ascending order of vectors
      if (vectors < totals_.size()) {
        count = static_cast<std::size_t>(std::lower_bound(first, first + count, vectors) - first);
      }
      bins.push_back({&values_[slot.begin], first, count, x.values[i]});
    }
  }
  return bins;
}

void VectorIndex::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  if (totals_.empty()) return;
  SparseVector scratch;
  const SparseVector& sparse = asSparse(x, scratch);
  const std::vector<Postings> bins = postingsOf(sparse, static_cast<std::size_t>(out.size()));
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
