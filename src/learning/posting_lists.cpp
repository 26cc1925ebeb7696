#include "learning/posting_lists.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/require.h"
#include "base/simd.h"
#include "learning/bin_table.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

using Slot = BinTable::Slot;

/// Calls visit(v, bin, value) for each element of each vector v, after prefetching the bin's slot
/// in `table`; accessing memory takes most of the time.
template <typename Visit>
void forEachElement(const std::vector<Feature>& vectors, std::size_t dimension,
                    const BinTable& table, Visit visit) {
  constexpr std::size_t kLookupsAhead = 8;
  SparseVector scratch;
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    const SparseVector& x = asSparse(vectors[v], dimension, scratch);
    for (std::size_t i = 0; i < x.size(); ++i) {
      table.prefetch(x.indices[std::min(i + kLookupsAhead, x.size() - 1)]);
      visit(v, x.indices[i], x.values[i]);
    }
  }
}

std::vector<Slot*> inAscendingOrder(BinTable& table) {
  std::vector<Slot*> slots;
  for (Slot& slot : table.slots()) {
    if (slot.count != 0) slots.push_back(&slot);
  }
  std::sort(slots.begin(), slots.end(),
            [](const Slot* a, const Slot* b) { return a->bin < b->bin; });
  return slots;
}

/// Assigns every bin in the table, which contains the counts, its position in the rows or postings.
void layOut(BinTable& table, PostingLists& lists) {
  std::uint32_t rows = 0;
  std::uint32_t postings = 0;
  for (Slot* slot : inAscendingOrder(table)) {
    lists.bins.push_back(slot->bin);
    lists.counts.push_back(slot->count);
    slot->begin = lists.isCommon(slot->count) ? rows++ : postings;
    if (!lists.isCommon(slot->count)) postings += slot->count;
  }
  lists.rows.assign(rows * lists.vectors(), 0);
  lists.values.resize(postings);
  lists.numbers.resize(postings);
}

DenseVector asDense(const SparseVector& x, std::size_t dimension) {
  DenseVector dense{std::vector<float>(dimension, 0)};
  for (std::size_t i = 0; i < x.size(); ++i) dense.values[x.indices[i]] = x.values[i];
  return dense;
}

PLACE_RECOGNITION_TARGET_CLONES
std::size_t countZeros(const float* values, std::size_t size) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; ++i) count += values[i] == 0;
  return count;
}

/// Number of values that are finite and not zero.
PLACE_RECOGNITION_TARGET_CLONES
std::size_t countElements(const float* values, std::size_t size) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const float magnitude = std::abs(values[i]);
    count += (magnitude > 0) & (magnitude < kInfinity);
  }
  return count;
}

/// Number of elements that are not greater than the previous one.
PLACE_RECOGNITION_TARGET_CLONES
std::size_t countDescents(const std::uint16_t* numbers, std::size_t size) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < size; ++i) count += numbers[i] <= numbers[i - 1];
  return count;
}

void requireTotalsFit(const PostingLists& lists) {
  require(lists.vectors() <= PostingLists::kMaxVectors, "there are too many support vectors");
  for (const double total : lists.totals) {
    require(total >= 0 && std::isfinite(total), "the total of a support vector is out of range");
  }
}

void requireBinsAscend(const PostingLists& lists) {
  const std::vector<std::uint64_t>& bins = lists.bins;
  require(std::adjacent_find(bins.begin(), bins.end(), std::greater_equal<>()) == bins.end(),
          "the bins of the support vectors are not in ascending order");
  require(lists.dimension == 0 || bins.empty() || bins.back() < lists.dimension,
          "an element of a support vector is beyond its dimension");
}

/// Checks that the sizes of rows and postings match the counts.
void requireSizesFit(const PostingLists& lists) {
  std::uint64_t rows = 0;
  std::uint64_t postings = 0;
  for (const std::uint32_t count : lists.counts) {
    require(count > 0 && count <= lists.vectors(), "a bin has no or too many support vectors");
    const bool common = lists.isCommon(count);
    rows += common;
    postings += common ? 0 : count;
  }
  require(lists.counts.size() == lists.bins.size() && lists.rows.size() == rows * lists.vectors() &&
              lists.values.size() == postings && lists.numbers.size() == postings,
          "the sizes of the support vectors do not add up");
}

/// Checks that every bin has as many vectors as its count, in ascending order.
void requireVectorsFit(const PostingLists& lists) {
  require(countElements(lists.values.data(), lists.values.size()) == lists.values.size(),
          "a support vector contains an element that is zero or not finite");
  const std::size_t vectors = lists.vectors();
  const float* row = lists.rows.data();
  const std::uint16_t* number = lists.numbers.data();
  std::size_t descents = 0;  // from one bin to the next, the only ones allowed
  for (const std::uint32_t count : lists.counts) {
    if (lists.isCommon(count)) {
      require(countElements(row, vectors) == count && countZeros(row, vectors) == vectors - count,
              "a bin does not have as many finite values as its count");
      row += vectors;
    } else {
      if (number != lists.numbers.data()) descents += number[0] <= number[-1];
      number += count;
      require(number[-1] < vectors, "a bin refers to a support vector that does not exist");
    }
  }
  require(countDescents(lists.numbers.data(), lists.numbers.size()) == descents,
          "the support vectors of a bin are not in ascending order");
}

}  // namespace

double total(Measure measure, const SparseVector& x) {
  double sum = 0;
  if (measure == Measure::kChiSquared) {
    for (const double value : x.values) sum += value;
  } else {
    for (const double value : x.values) sum += value * value;
  }
  return sum;
}

PostingLists postingLists(Measure measure, const std::vector<Feature>& vectors) {
  if (vectors.size() > PostingLists::kMaxVectors) {
    throw Error("There are " + std::to_string(vectors.size()) + " support vectors, more than the " +
                std::to_string(PostingLists::kMaxVectors) +
                " that can be compared; train on fewer images.");
  }
  PostingLists lists;
  if (vectors.empty()) return lists;
  const auto* dense = std::get_if<DenseVector>(&vectors.front());
  if (dense) lists.dimension = dense->values.size();
  SparseVector scratch;
  for (const Feature& vector : vectors) {
    lists.totals.push_back(total(measure, asSparse(vector, lists.dimension, scratch)));
  }

  BinTable table;
  forEachElement(vectors, lists.dimension, table,
                 [&](std::size_t, std::uint64_t bin, float) { ++table.insert(bin).count; });
  layOut(table, lists);
  const auto fill = [&](std::size_t v, std::uint64_t bin, float value) {
    Slot& slot = table.find(bin);
    if (lists.isCommon(slot.count)) {
      lists.rows[slot.begin * lists.vectors() + v] = value;
    } else {
      lists.numbers[slot.begin] = static_cast<std::uint16_t>(v);
      lists.values[slot.begin++] = value;
    }
  };
  forEachElement(vectors, lists.dimension, table, fill);
  return lists;
}

std::vector<Feature> vectorsOf(const PostingLists& lists) {
  std::vector<SparseVector> vectors(lists.vectors());
  const auto append = [&vectors](std::size_t v, std::uint64_t bin, float value) {
    vectors[v].indices.push_back(bin);
    vectors[v].values.push_back(value);
  };
  const float* row = lists.rows.data();
  std::size_t posting = 0;
  for (std::size_t b = 0; b < lists.bins.size(); ++b) {
    if (lists.isCommon(lists.counts[b])) {
      for (std::size_t v = 0; v < lists.vectors(); ++v) {
        if (row[v] != 0) append(v, lists.bins[b], row[v]);
      }
      row += lists.vectors();
    } else {
      for (const std::size_t end = posting + lists.counts[b]; posting < end; ++posting) {
        append(lists.numbers[posting], lists.bins[b], lists.values[posting]);
      }
    }
  }
  std::vector<Feature> features;
  for (SparseVector& vector : vectors) {
    if (lists.dimension > 0) {
      features.emplace_back(asDense(vector, lists.dimension));
    } else {
      features.emplace_back(std::move(vector));
    }
  }
  return features;
}

void PostingLists::check() const {
  requireTotalsFit(*this);
  requireBinsAscend(*this);
  requireSizesFit(*this);
  requireVectorsFit(*this);
}

const SparseVector& asSparse(const Feature& x, std::size_t dimension, SparseVector& scratch) {
  const auto* sparse = std::get_if<SparseVector>(&x);
  if (sparse && dimension == 0) return *sparse;
  const auto* dense = std::get_if<DenseVector>(&x);
  if (!dense || dimension == 0) {
    throw Error("Cannot compare features of two kinds; extract both with the same options.");
  }
  if (dense->values.size() != dimension) {
    throw Error("Cannot compare a vector of " + std::to_string(dense->values.size()) +
                " elements with vectors of " + std::to_string(dimension) +
                "; extract both with the same options.");
  }
  scratch.indices.clear();
  scratch.values.clear();
  for (std::size_t i = 0; i < dimension; ++i) {
    if (dense->values[i] == 0) continue;
    scratch.indices.push_back(i);
    scratch.values.push_back(dense->values[i]);
  }
  return scratch;
}

}  // namespace place_recognition
