#include "crfh_limit.h"

#include <cstring>

#include "base/simd.h"
#include "features/gaussian.h"

// Compiled with -ffp-contract=fast, unlike the package, so that products and sums are fused.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    PLACE_RECOGNITION_VECTOR_BITS >= 256
#if PLACE_RECOGNITION_VECTOR_BITS >= 512
#define WITH_FUSED_MULTIPLY_ADD __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define WITH_FUSED_MULTIPLY_ADD __attribute__((target_clones("fma", "default")))
#endif
#else
#define WITH_FUSED_MULTIPLY_ADD
#endif

namespace place_recognition {
namespace {

constexpr int kMostTaps = 40;

template <int kTaps>
PLACE_RECOGNITION_INLINE void multiplyAddFixed(const float* in, float weight, std::size_t n,
                                               float* out) {
  PLACE_RECOGNITION_INDEPENDENT
  for (std::size_t x = 0; x < n; ++x) {
    float sum = 0;
#pragma GCC unroll 40
    for (int i = 0; i < kTaps; ++i) sum += weight * in[x + i];
    out[x] = sum;
  }
}

template <int kTaps = kMostTaps>
PLACE_RECOGNITION_INLINE void multiplyAddUpTo(int taps, const float* in, float weight,
                                              std::size_t n, float* out) {
  if (taps == kTaps) {
    multiplyAddFixed<kTaps>(in, weight, n, out);
  } else if constexpr (kTaps > 2) {
    multiplyAddUpTo<kTaps - 2>(taps, in, weight, n, out);
  }
}

/// out[x] = the sum of weight * in[x + i] over i < `taps`, an even number from 2.
WITH_FUSED_MULTIPLY_ADD
void multiplyAdd(const float* in, float weight, int taps, std::size_t n, float* out) {
  multiplyAddUpTo(taps, in, weight, n, out);
}

}  // namespace

CrfhLimit::CrfhLimit(const std::vector<double>& variances) {
  for (double t : variances) taps_.push_back(2 * (2 * gaussianHalfWidth(t, 3) + 1));
}

void CrfhLimit::compute(cv::Size size) {
  images_.create(2 * size.height, size.width);
  const std::size_t pixels = size.area();
  float* const source = images_[0];
  float* const target = source + pixels;
  for (int taps : taps_) {
    std::memcpy(source, target, pixels * sizeof(float));
    multiplyAdd(source, 1.f / taps, taps, pixels - taps, target);
  }
}

}  // namespace place_recognition
