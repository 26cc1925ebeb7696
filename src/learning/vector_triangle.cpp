#include "learning/vector_triangle.h"

#include <cassert>
#include <numeric>

namespace place_recognition {
namespace {

/// The number of elements of each vector.
std::vector<std::size_t> countElements(const PostingLists& lists) {
  std::vector<std::size_t> counts(lists.vectors(), 0);
  for (const std::uint16_t v : lists.numbers) ++counts[v];
  for (std::size_t i = 0; i < lists.rows.size(); ++i) {
    counts[i % lists.vectors()] += lists.rows[i] != 0;
  }
  return counts;
}

}  // namespace

VectorTriangle::VectorTriangle(const VectorIndex& index)
    : index_(index), begins_(index.size() + 1) {
  const PostingLists& lists = index.lists();
  const std::vector<std::size_t> counts = countElements(lists);
  std::partial_sum(counts.begin(), counts.end(), begins_.begin() + 1);
  elements_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);  // element of each vector

  std::uint32_t row = 0;
  std::uint32_t begin = 0;
  for (const std::uint32_t count : lists.counts) {
    if (lists.isCommon(count)) {
      const float* values = &lists.rows[row * lists.vectors()];
      for (std::size_t v = 0; v < lists.vectors(); ++v) {
        if (values[v] != 0) elements_[next[v]++] = {row, 0, values[v]};
      }
      ++row;
    } else {
      for (std::uint32_t i = 0; i < count; ++i) {
        elements_[next[lists.numbers[begin + i]]++] = {begin, i + 1, lists.values[begin + i]};
      }
      begin += count;
    }
  }
}

void VectorTriangle::measures(std::size_t v, Eigen::Ref<Eigen::VectorXd> out) const {
  assert(static_cast<std::size_t>(out.size()) == v + 1);
  const PostingLists& lists = index_.lists();
  std::vector<VectorIndex::Postings> bins;
  bins.reserve(begins_[v + 1] - begins_[v]);
  for (std::size_t e = begins_[v]; e < begins_[v + 1]; ++e) {
    const Element& element = elements_[e];
    if (element.count == 0) {
      bins.push_back({&lists.rows[element.begin * lists.vectors()], nullptr, v + 1, element.value});
    } else {
      bins.push_back({&lists.values[element.begin], &lists.numbers[element.begin], element.count,
                      element.value});
    }
  }
  index_.measures(bins, lists.totals[v], out);
}

}  // namespace place_recognition
