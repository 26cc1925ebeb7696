#include "match_peak.h"

#include <string>

#include "learning/match_panels.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace place_recognition {
namespace {

constexpr int kSums = 16;  // independent of each other, so that none has to wait

#if defined(__x86_64__)
__attribute__((target("avx512f,avx512bw,avx512vnni"))) std::int64_t peakOfVnni(std::int64_t rounds,
                                                                               std::int32_t& seed) {
  __m512i sums[kSums];
  for (int i = 0; i < kSums; ++i) sums[i] = _mm512_set1_epi32(seed + i);
  const __m512i a = _mm512_set1_epi8(static_cast<char>(seed));
  const __m512i b = _mm512_set1_epi8(static_cast<char>(seed + 1));
  for (std::int64_t round = 0; round < rounds; ++round) {
    for (int i = 0; i < kSums; ++i) {
      sums[i] = _mm512_dpbusd_epi32(sums[i], a, b);
      asm volatile("" : "+v"(sums[i]));  // keeps the compiler from removing any
    }
  }
  for (int i = 1; i < kSums; ++i) sums[0] = _mm512_add_epi32(sums[0], sums[i]);
  std::int32_t lanes[16];
  _mm512_storeu_si512(lanes, sums[0]);
  seed ^= lanes[0];
  return rounds * kSums * 64;
}

__attribute__((target("avx2"))) std::int64_t peakOfAvx2(std::int64_t rounds, std::int32_t& seed) {
  constexpr int kRegisters = 12;  // of the sixteen available
  __m256i sums[kRegisters];
  for (int i = 0; i < kRegisters; ++i) sums[i] = _mm256_set1_epi32(seed + i);
  const __m256i a = _mm256_set1_epi16(static_cast<short>(seed));
  const __m256i b = _mm256_set1_epi16(static_cast<short>(seed + 1));
  for (std::int64_t round = 0; round < rounds; ++round) {
    for (int i = 0; i < kRegisters; ++i) {
      __m256i products = _mm256_madd_epi16(a, b);
      asm volatile("" : "+x"(products));
      sums[i] = _mm256_add_epi32(sums[i], products);
      asm volatile("" : "+x"(sums[i]));
    }
  }
  for (int i = 1; i < kRegisters; ++i) sums[0] = _mm256_add_epi32(sums[0], sums[i]);
  seed ^= _mm_cvtsi128_si32(_mm256_castsi256_si128(sums[0]));
  return rounds * kRegisters * 16;
}
#endif

std::int64_t peakOfPlainLoop(std::int64_t rounds, std::int32_t& seed) {
  std::uint32_t sums[4 * kSums] = {};
  const auto a = static_cast<std::uint32_t>(seed);
  for (std::int64_t round = 0; round < rounds; ++round) {
    for (std::uint32_t& sum : sums) sum += a * static_cast<std::uint8_t>(round);
  }
  for (const std::uint32_t sum : sums) seed = static_cast<std::int32_t>(seed ^ sum);
  return rounds * 4 * kSums;
}

}  // namespace

std::int64_t multiplyAddAtPeak(std::int64_t rounds, std::int32_t& seed) {
#if defined(__x86_64__)
  const std::string fastest = matchVariants().back().name;
  if (fastest == "VNNI") return peakOfVnni(rounds, seed);
  if (fastest == "AVX2") return peakOfAvx2(rounds, seed);
#endif
  return peakOfPlainLoop(rounds, seed);
}

}  // namespace place_recognition
