#include "learning/posting_lists.h"

#include <algorithm>

#include "base/require.h"
#include "base/simd.h"
#include "learning/bin_table.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

using Bin = PostingLists::Bin;
using Slot = BinTable::Slot;

/// Seven bits a byte, the lowest first; the top bit says that more follow.
void appendVarint(std::vector<std::uint8_t>& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<std::uint8_t>(value | 0x80));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

/// The varint at `position`, which moves on behind it.
std::uint64_t readVarint(const std::vector<std::uint8_t>& bytes, std::size_t& position) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64 && position < bytes.size(); shift += 7) {
    const std::uint64_t byte = bytes[position++];
    if (shift == 63 && byte > 1) break;
    value |= (byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  throw Error("the bins of the support vectors are cut or too large");
}

/// Calls visit(v, bin, value) for each element of each vector v, after asking the memory for the
/// bin's slot in `table`; visiting the memory is what takes the time.
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

/// Gives every bin, counted in the table, its place in the rows or among the postings.
void layOut(BinTable& table, PostingLists& lists) {
  std::uint32_t rows = 0;
  std::uint32_t postings = 0;
  std::uint64_t before = 0;
  for (Slot* slot : inAscendingOrder(table)) {
    appendVarint(lists.bins, slot->bin - before);
    appendVarint(lists.bins, slot->count);
    before = slot->bin;
    slot->begin = lists.isCommon(slot->count) ? rows++ : postings;
    if (!lists.isCommon(slot->count)) postings += slot->count;
  }
  lists.rows.assign(rows * lists.vectors, 0);
  lists.values.resize(postings);
  lists.numbers.resize(postings);
}

DenseVector asDense(const SparseVector& x, std::size_t dimension) {
  DenseVector dense{std::vector<float>(dimension, 0)};
  for (std::size_t i = 0; i < x.size(); ++i) dense.values[x.indices[i]] = x.values[i];
  return dense;
}

PLACE_RECOGNITION_TARGET_CLONES
std::size_t countNonZero(const float* values, std::size_t size) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; ++i) count += values[i] != 0;
  return count;
}

/// How many numbers are not above the one before.
PLACE_RECOGNITION_TARGET_CLONES
std::size_t countDescents(const HugeVector<std::uint16_t>& numbers) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) count += numbers[i] <= numbers[i - 1];
  return count;
}

/// As lists.bins has them, in ascending order.
std::vector<Bin> decodeBins(const PostingLists& lists) {
  std::vector<Bin> bins;
  bins.reserve(lists.bins.size() / 2);  // each has two bytes at least
  std::uint64_t index = 0;
  for (std::size_t position = 0; position < lists.bins.size();) {
    const std::uint64_t step = readVarint(lists.bins, position);
    const std::uint64_t count = readVarint(lists.bins, position);
    require((step > 0 || bins.empty()) && step <= ~index,
            "the bins of the support vectors do not ascend");
    require(count > 0 && count <= lists.vectors, "a bin is of none or of too many support vectors");
    index += step;
    bins.push_back({index, static_cast<std::uint32_t>(count)});
  }
  require(lists.dimension == 0 || bins.empty() || index < lists.dimension,
          "a support vector has not the dimension of the extractor's");
  return bins;
}

/// That rows and postings are as many as `bins` says.
void requireSizesFit(const PostingLists& lists, const std::vector<Bin>& bins) {
  std::uint64_t rows = 0;
  std::uint64_t postings = 0;
  for (const Bin& bin : bins) {
    if (lists.isCommon(bin.count)) {
      ++rows;
    } else {
      postings += bin.count;
    }
  }
  require(lists.rows.size() == rows * lists.vectors && lists.values.size() == postings &&
              lists.numbers.size() == postings,
          "the sizes of the support vectors do not add up");
}

/// That every bin has as many vectors as it says, in ascending order.
void requireVectorsFit(const PostingLists& lists, const std::vector<Bin>& bins) {
  require(countNonZero(lists.values.data(), lists.values.size()) == lists.values.size(),
          "a support vector holds a zero element");
  const float* row = lists.rows.data();
  const std::uint16_t* number = lists.numbers.data();
  std::size_t descents = 0;  // from one bin to the next, the only ones that may be
  for (const Bin& bin : bins) {
    if (lists.isCommon(bin.count)) {
      require(countNonZero(row, lists.vectors) == bin.count,
              "a bin has not as many support vectors as it says");
      row += lists.vectors;
    } else {
      if (number != lists.numbers.data()) descents += number[0] <= number[-1];
      number += bin.count;
      require(number[-1] < lists.vectors, "a bin is of a support vector that there is not");
    }
  }
  require(countDescents(lists.numbers) == descents, "the support vectors of a bin do not ascend");
}

}  // namespace

PostingLists postingLists(const std::vector<Feature>& vectors) {
  if (vectors.size() > PostingLists::kMaxVectors) {
    throw Error("There are " + std::to_string(vectors.size()) + " support vectors, more than the " +
                std::to_string(PostingLists::kMaxVectors) +
                " that can be compared; train on fewer images.");
  }
  PostingLists lists;
  lists.vectors = vectors.size();
  if (vectors.empty()) return lists;
  const auto* dense = std::get_if<DenseVector>(&vectors.front());
  if (dense) lists.dimension = dense->values.size();

  BinTable table;
  forEachElement(vectors, lists.dimension, table,
                 [&](std::size_t, std::uint64_t bin, float) { ++table.insert(bin).count; });
  layOut(table, lists);
  const auto fill = [&](std::size_t v, std::uint64_t bin, float value) {
    Slot& slot = table.find(bin);
    if (lists.isCommon(slot.count)) {
      lists.rows[slot.begin * lists.vectors + v] = value;
    } else {
      lists.numbers[slot.begin] = static_cast<std::uint16_t>(v);
      lists.values[slot.begin++] = value;
    }
  };
  forEachElement(vectors, lists.dimension, table, fill);
  return lists;
}

std::vector<Feature> vectorsOf(const PostingLists& lists) {
  std::vector<SparseVector> vectors(lists.vectors);
  const auto append = [&vectors](std::size_t v, std::uint64_t bin, float value) {
    vectors[v].indices.push_back(bin);
    vectors[v].values.push_back(value);
  };
  const float* row = lists.rows.data();
  std::size_t posting = 0;
  for (const Bin& bin : binsOf(lists)) {
    if (lists.isCommon(bin.count)) {
      for (std::size_t v = 0; v < lists.vectors; ++v) {
        if (row[v] != 0) append(v, bin.index, row[v]);
      }
      row += lists.vectors;
    } else {
      for (const std::size_t end = posting + bin.count; posting < end; ++posting) {
        append(lists.numbers[posting], bin.index, lists.values[posting]);
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

std::vector<Bin> binsOf(const PostingLists& lists) {
  require(lists.vectors <= PostingLists::kMaxVectors, "there are too many support vectors");
  std::vector<Bin> bins = decodeBins(lists);
  requireSizesFit(lists, bins);
  requireVectorsFit(lists, bins);
  return bins;
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
