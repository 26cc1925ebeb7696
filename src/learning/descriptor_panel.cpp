#include "learning/descriptor_panel.h"

#include <algorithm>
#include <numeric>

namespace place_recognition {
namespace {

constexpr std::size_t kDimension = DescriptorSet::kDimension;

std::int32_t squaredNorm(const std::uint8_t* descriptor) {
  return std::inner_product(descriptor, descriptor + kDimension, descriptor, std::int32_t{0});
}

}  // namespace

DescriptorPanel::DescriptorPanel() { std::fill(squared_norms, squared_norms + kWidth, kFar); }

void DescriptorPanel::set(std::size_t lane, const std::uint8_t* descriptor) {
  for (std::size_t k = 0; k < kDimension; ++k) elements[k / 4][lane][k % 4] = descriptor[k];
  squared_norms[lane] = squaredNorm(descriptor);
  sums_by_128[lane] = 128 * std::accumulate(descriptor, descriptor + kDimension, std::int32_t{0});
}

void DescriptorPanel::get(std::size_t lane, std::uint8_t* descriptor) const {
  for (std::size_t k = 0; k < kDimension; ++k) descriptor[k] = elements[k / 4][lane][k % 4];
}

DescriptorBlock::DescriptorBlock() {
  std::fill(squared_norms, squared_norms + kRows, DescriptorPanel::kFar);
}

void DescriptorBlock::set(std::size_t row, const std::uint8_t* descriptor) {
  std::copy(descriptor, descriptor + kDimension, elements[row]);
  squared_norms[row] = squaredNorm(descriptor);
}

}  // namespace place_recognition
