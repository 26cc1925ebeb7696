#include "learning/bin_slices.h"

#include <algorithm>

namespace place_recognition {
namespace {

constexpr std::size_t kElementsASlice = 1 << 16;
/// Every so many elements one is looked at to find where slices of about this size end.
constexpr std::size_t kSampleStep = 64;

}  // namespace

BinSlices::BinSlices(std::vector<const SparseVector*> vectors)
    : vectors_(std::move(vectors)), end_(vectors_.size(), 0) {
  std::vector<std::uint64_t> sample;
  std::size_t next_sample = 0;
  for (const SparseVector* vector : vectors_) {
    for (; next_sample < elements_ + vector->size(); next_sample += kSampleStep) {
      sample.push_back(vector->indices[next_sample - elements_]);
    }
    elements_ += vector->size();
  }
  std::sort(sample.begin(), sample.end());
  constexpr std::size_t kSamplesASlice = kElementsASlice / kSampleStep;
  for (std::size_t i = kSamplesASlice; i < sample.size(); i += kSamplesASlice) {
    if (bounds_.empty() || bounds_.back() != sample[i]) bounds_.push_back(sample[i]);
  }
}

bool BinSlices::next() {
  if (slice_ > bounds_.size()) return false;
  begin_ = end_;
  for (std::size_t v = 0; v < vectors_.size(); ++v) {
    const std::vector<std::uint64_t>& bins = vectors_[v]->indices;
    end_[v] = bins.size();
    if (slice_ < bounds_.size()) {
      const auto from = bins.begin() + static_cast<std::ptrdiff_t>(begin_[v]);
      end_[v] = static_cast<std::size_t>(std::lower_bound(from, bins.end(), bounds_[slice_]) -
                                         bins.begin());
    }
  }
  ++slice_;
  return true;
}

}  // namespace place_recognition
