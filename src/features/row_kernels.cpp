#include "features/row_kernels.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// The two mirrored samples that one tap of a kernel meets.
template <int kOrder>
PLACE_RECOGNITION_INLINE float mirrored(float before, float here, float after) {
  if constexpr (kOrder == 0) return before + after;
  if constexpr (kOrder == 1) return after - before;
  if constexpr (kOrder == 2) return (before + after) - 2 * here;
}

/// out = the first sizeof...(I) taps beside the centre and, if kFirst, the centre; else out += the
/// next ones, from `tap` on. One expression, so that the sum stays in a register.
template <int kOrder, bool kFirst, std::size_t... I>
PLACE_RECOGNITION_INLINE void addTaps(const float* in, std::ptrdiff_t stride, const float* taps,
                                      int tap, int n, float* out, std::index_sequence<I...>) {
  const float centre = taps[0];
  const float weight[] = {taps[tap + I]...};
  const float* const before[] = {in - (tap + static_cast<int>(I)) * stride...};
  const float* const after[] = {in + (tap + static_cast<int>(I)) * stride...};
  PLACE_RECOGNITION_INDEPENDENT
  for (int x = 0; x < n; ++x) {
    float sum = !kFirst ? out[x] : kOrder == 0 ? centre * in[x] : 0.0f;
    ((sum += weight[I] * mirrored<kOrder>(before[I][x], in[x], after[I][x])), ...);
    out[x] = sum;
  }
}

constexpr int kMostTaps = 8;  // At a time: more would not fit the registers.

template <int kOrder, bool kFirst, int kCount = kMostTaps>
PLACE_RECOGNITION_INLINE void addUpTo(int count, const float* in, std::ptrdiff_t stride,
                                      const float* taps, int tap, int n, float* out) {
  if constexpr (kCount > 0) {
    if (count >= kCount) {
      addTaps<kOrder, kFirst>(in, stride, taps, tap, n, out, std::make_index_sequence<kCount>());
    } else {
      addUpTo<kOrder, kFirst, kCount - 1>(count, in, stride, taps, tap, n, out);
    }
  }
}

template <int kOrder>
PLACE_RECOGNITION_INLINE void correlateOrder(const float* in, std::ptrdiff_t stride,
                                             const float* taps, int half, int n, float* out) {
  addUpTo<kOrder, true>(half, in, stride, taps, 1, n, out);
  for (int tap = 1 + kMostTaps; tap <= half; tap += kMostTaps) {
    addUpTo<kOrder, false>(half - tap + 1, in, stride, taps, tap, n, out);
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void correlate0(const float* in, std::ptrdiff_t stride, const float* taps, int half, int n,
                float* out) {
  correlateOrder<0>(in, stride, taps, half, n, out);
}

PLACE_RECOGNITION_TARGET_CLONES
void correlate1(const float* in, std::ptrdiff_t stride, const float* taps, int half, int n,
                float* out) {
  correlateOrder<1>(in, stride, taps, half, n, out);
}

PLACE_RECOGNITION_TARGET_CLONES
void correlate2(const float* in, std::ptrdiff_t stride, const float* taps, int half, int n,
                float* out) {
  correlateOrder<2>(in, stride, taps, half, n, out);
}

/// As addTaps() of order 0, 1 and 2, from the same samples.
template <bool kFirst, std::size_t... I>
PLACE_RECOGNITION_INLINE void addTapsOfOrders(const float* in, std::ptrdiff_t stride,
                                              const float* const* taps, int tap, int n,
                                              float* const* out, std::index_sequence<I...>) {
  const float centre = taps[0][0];
  const float weight[3][sizeof...(I)] = {
      {taps[0][tap + I]...}, {taps[1][tap + I]...}, {taps[2][tap + I]...}};
  const float* const before[] = {in - (tap + static_cast<int>(I)) * stride...};
  const float* const after[] = {in + (tap + static_cast<int>(I)) * stride...};
  float *out_0 = out[0], *out_1 = out[1], *out_2 = out[2];
  PLACE_RECOGNITION_INDEPENDENT
  for (int x = 0; x < n; ++x) {
    const float here = in[x];
    float sum_0 = kFirst ? centre * here : out_0[x];
    float sum_1 = kFirst ? 0.0f : out_1[x];
    float sum_2 = kFirst ? 0.0f : out_2[x];
    ((sum_0 += weight[0][I] * mirrored<0>(before[I][x], here, after[I][x]),
      sum_1 += weight[1][I] * mirrored<1>(before[I][x], here, after[I][x]),
      sum_2 += weight[2][I] * mirrored<2>(before[I][x], here, after[I][x])),
     ...);
    out_0[x] = sum_0;
    out_1[x] = sum_1;
    out_2[x] = sum_2;
  }
}

constexpr int kMostTapsOfOrders = 5;

template <bool kFirst, int kCount = kMostTapsOfOrders>
PLACE_RECOGNITION_INLINE void addUpToOfOrders(int count, const float* in, std::ptrdiff_t stride,
                                              const float* const* taps, int tap, int n,
                                              float* const* out) {
  if constexpr (kCount > 0) {
    if (count >= kCount) {
      addTapsOfOrders<kFirst>(in, stride, taps, tap, n, out, std::make_index_sequence<kCount>());
    } else {
      addUpToOfOrders<kFirst, kCount - 1>(count, in, stride, taps, tap, n, out);
    }
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void correlate012(const float* in, std::ptrdiff_t stride, const float* const* taps, int half, int n,
                  float* const* out) {
  addUpToOfOrders<true>(half, in, stride, taps, 1, n, out);
  for (int tap = 1 + kMostTapsOfOrders; tap <= half; tap += kMostTapsOfOrders) {
    addUpToOfOrders<false>(half - tap + 1, in, stride, taps, tap, n, out);
  }
}

}  // namespace

void correlateOrders(const float* in, std::ptrdiff_t stride,
                     const std::array<HalfKernel, 3>& kernels, int n,
                     const std::array<float*, 3>& out) {
  const int half = kernels[0].halfWidth();
  assert(kernels[1].halfWidth() == half && kernels[2].halfWidth() == half);
  const float* const taps[] = {kernels[0].taps.data(), kernels[1].taps.data(),
                               kernels[2].taps.data()};
  correlate012(in, stride, taps, half, n, out.data());
}

void correlate(const float* in, std::ptrdiff_t stride, const HalfKernel& kernel, int n,
               float* out) {
  const auto function = kernel.order == 0   ? correlate0
                        : kernel.order == 1 ? correlate1
                                            : correlate2;
  function(in, stride, kernel.taps.data(), kernel.halfWidth(), n, out);
}

PLACE_RECOGNITION_TARGET_CLONES
void gradientMagnitude(const float* __restrict x_row, const float* __restrict y_row, int n,
                       float* __restrict out) {
  for (int x = 0; x < n; ++x) out[x] = std::sqrt(x_row[x] * x_row[x] + y_row[x] * y_row[x]);
}

PLACE_RECOGNITION_TARGET_CLONES
void laplacian(const float* __restrict xx, const float* __restrict yy, int n,
               float* __restrict out) {
  for (int x = 0; x < n; ++x) out[x] = xx[x] + yy[x];
}

PLACE_RECOGNITION_TARGET_CLONES
void hessianDeterminant(const float* __restrict xx, const float* __restrict xy,
                        const float* __restrict yy, int n, float* __restrict out) {
  for (int x = 0; x < n; ++x) out[x] = xx[x] * yy[x] - xy[x] * xy[x];
}

PLACE_RECOGNITION_TARGET_CLONES
void quantize(const float* __restrict response, const Quantizer& quantizer, bool add, int n,
              std::uint32_t* __restrict index) {
  const auto [gain, offset, lowest, highest, weight] = quantizer;
  for (int x = 0; x < n; ++x) {
    float level = std::floor(gain * response[x] + offset);
    level = level > lowest ? level : lowest;
    level = level < highest ? level : highest;
    const std::uint32_t digit =
        weight * static_cast<std::uint32_t>(static_cast<int>(level - lowest));
    index[x] = add ? index[x] + digit : digit;
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void joinWord(const std::uint32_t* __restrict digits, std::uint64_t weight, bool add, int n,
              std::uint64_t* __restrict number) {
  for (int x = 0; x < n; ++x) number[x] = (add ? number[x] : 0) + weight * digits[x];
}

}  // namespace place_recognition
