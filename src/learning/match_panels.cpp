#include "learning/match_panels.h"

#include <algorithm>
#include <numeric>

#include "base/simd.h"

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

void matchPanelsPlainly(const DescriptorBlock& block, const DescriptorPanel* panels,
                        std::size_t panel_count, BlockByPanel& row_nearest,
                        std::int32_t* panel_nearest) {
  constexpr std::size_t kWidth = DescriptorPanel::kWidth;
  for (std::size_t p = 0; p < panel_count; ++p) {
    BlockByPanel products;
    for (std::size_t r = 0; r < DescriptorBlock::kRows; ++r) {
      std::int32_t parts[kWidth][4] = {};  // the order that compilers vectorize
      for (std::size_t k = 0; k < DescriptorPanel::kSteps; ++k) {
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
          for (std::size_t i = 0; i < 4; ++i) {
            parts[lane][i] += block.elements[r][4 * k + i] * panels[p].elements[k][lane][i];
          }
        }
      }
      for (std::size_t lane = 0; lane < kWidth; ++lane) {
        products[r][lane] = parts[lane][0] + parts[lane][1] + parts[lane][2] + parts[lane][3];
      }
    }
    lowerNearest(products, block, panels[p], row_nearest, panel_nearest + p * kWidth);
  }
}

std::vector<MatchVariant> matchVariants() {
  std::vector<MatchVariant> variants = {{"plain", &matchPanelsPlainly}};
#if defined(__x86_64__)
  constexpr int kBits = PLACE_RECOGNITION_VECTOR_BITS;
  if (kBits >= 256 && __builtin_cpu_supports("avx2")) {
    variants.push_back({"AVX2", &matchPanelsAvx2});
  }
  if (kBits >= 512 && __builtin_cpu_supports("avx512vnni")) {
    variants.push_back({"VNNI", &matchPanelsVnni});
  }
#endif
  return variants;
}

}  // namespace place_recognition
