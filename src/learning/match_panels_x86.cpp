#include "learning/match_panels.h"

#if defined(__x86_64__)
#include <immintrin.h>

#include <algorithm>
#include <cstring>

#define TARGET_AVX2 __attribute__((target("avx2")))
#define TARGET_VNNI __attribute__((target("avx512f,avx512bw,avx512vnni")))

namespace place_recognition {
namespace {

constexpr std::size_t kRows = DescriptorBlock::kRows;
constexpr std::size_t kWidth = DescriptorPanel::kWidth;
constexpr std::size_t kSteps = DescriptorPanel::kSteps;

/// Four descriptors of a panel, as 16-bit numbers.
TARGET_AVX2 inline __m256i widen(const std::uint8_t (*elements)[4]) {
  return _mm256_cvtepu8_epi16(_mm_load_si128(reinterpret_cast<const __m128i*>(elements)));
}

/// Products of four rows (each 64-bit number holds one step's elements, 16 bits each) with eight
/// lanes of a panel.
TARGET_AVX2 inline void multiply(const std::int64_t (*rows)[kSteps], const DescriptorPanel& panel,
                                 std::size_t lane, std::int32_t (*products)[kWidth]) {
  constexpr std::size_t kRowsAtOnce = 4;
  __m256i low[kRowsAtOnce];   // of the first four lanes, two sums each
  __m256i high[kRowsAtOnce];  // of the others
  for (std::size_t r = 0; r < kRowsAtOnce; ++r) low[r] = high[r] = _mm256_setzero_si256();
  for (std::size_t k = 0; k < kSteps; ++k) {
    const __m256i low_lanes = widen(panel.elements[k] + lane);
    const __m256i high_lanes = widen(panel.elements[k] + lane + 4);
    for (std::size_t r = 0; r < kRowsAtOnce; ++r) {
      const __m256i four = _mm256_set1_epi64x(rows[r][k]);
      low[r] = _mm256_add_epi32(low[r], _mm256_madd_epi16(low_lanes, four));
      high[r] = _mm256_add_epi32(high[r], _mm256_madd_epi16(high_lanes, four));
    }
  }
  for (std::size_t r = 0; r < kRowsAtOnce; ++r) {
    const __m256i mixed = _mm256_hadd_epi32(low[r], high[r]);  // lanes 0 1 4 5 2 3 6 7
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(products[r] + lane),
                        _mm256_permute4x64_epi64(mixed, 0b11011000));
  }
}

}  // namespace

TARGET_AVX2 void matchPanelsAvx2(const DescriptorBlock& block, const DescriptorPanel* panels,
                                 std::size_t panel_count, BlockByPanel& row_nearest,
                                 std::int32_t* panel_nearest) {
  std::int16_t wide[sizeof(block.elements)];
  std::copy_n(&block.elements[0][0], sizeof(block.elements), wide);
  std::int64_t rows[kRows][kSteps];
  std::memcpy(rows, wide, sizeof(rows));
  for (std::size_t p = 0; p < panel_count; ++p) {
    alignas(64) BlockByPanel products;
    for (std::size_t row = 0; row < kRows; row += 4) {
      for (std::size_t lane = 0; lane < kWidth; lane += 8) {
        multiply(rows + row, panels[p], lane, products + row);
      }
    }
    lowerNearest(products, block, panels[p], row_nearest, panel_nearest + p * kWidth);
  }
}

TARGET_VNNI void matchPanelsVnni(const DescriptorBlock& block, const DescriptorPanel* panels,
                                 std::size_t panel_count, BlockByPanel& row_nearest,
                                 std::int32_t* panel_nearest) {
  // The instruction multiplies unsigned with signed bytes: a'b = a'(b - 128) + 128 sum a.
  std::int32_t rows[kRows][kSteps];  // four elements each
  std::memcpy(rows, block.elements, sizeof(rows));
  for (auto& row : rows) {
    for (std::int32_t& four : row) four ^= static_cast<std::int32_t>(0x80808080);
  }
  for (std::size_t p = 0; p < panel_count; ++p) {
    __m512i left[kRows];  // half of the lanes
    __m512i right[kRows];
    for (std::size_t r = 0; r < kRows; ++r) {
      left[r] = _mm512_load_si512(panels[p].sums_by_128);
      right[r] = _mm512_load_si512(panels[p].sums_by_128 + kWidth / 2);
    }
    for (std::size_t k = 0; k < kSteps; ++k) {
      const __m512i left_lanes = _mm512_load_si512(panels[p].elements[k]);
      const __m512i right_lanes = _mm512_load_si512(panels[p].elements[k] + kWidth / 2);
      for (std::size_t r = 0; r < kRows; ++r) {
        const __m512i four = _mm512_set1_epi32(rows[r][k]);
        left[r] = _mm512_dpbusd_epi32(left[r], left_lanes, four);
        right[r] = _mm512_dpbusd_epi32(right[r], right_lanes, four);
      }
    }
    alignas(64) BlockByPanel products;
    for (std::size_t r = 0; r < kRows; ++r) {
      _mm512_store_si512(products[r], left[r]);
      _mm512_store_si512(products[r] + kWidth / 2, right[r]);
    }
    lowerNearest(products, block, panels[p], row_nearest, panel_nearest + p * kWidth);
  }
}

}  // namespace place_recognition
#endif
