#include "features/row_kernels.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// Orders of derivatives, one bit each.
using Orders = unsigned;
constexpr Orders kAllOrders = 7;

constexpr bool contains(Orders orders, int order) { return (orders >> order & 1) != 0; }
constexpr int count(Orders orders) {
  return contains(orders, 0) + contains(orders, 1) + contains(orders, 2);
}

/// Adds the contribution of one tap of the kernel of order kOrder, given the two mirrored samples,
/// if that order is one of kOrders.
template <Orders kOrders, int kOrder>
PLACE_RECOGNITION_INLINE void addTap([[maybe_unused]] float weight, [[maybe_unused]] float before,
                                     [[maybe_unused]] float here, [[maybe_unused]] float after,
                                     [[maybe_unused]] float& sum) {
  if constexpr (!contains(kOrders, kOrder)) return;
  if constexpr (kOrder == 0) sum += weight * (before + after);
  if constexpr (kOrder == 1) sum += weight * (after - before);
  if constexpr (kOrder == 2) sum += weight * ((before + after) - 2 * here);
}

/// Sets out[order] to the sum of the first sizeof...(I) taps beside the centre and, if kFirst, the
/// centre; otherwise adds the next taps, starting at `tap`. A single loop keeps the sums in
/// registers.
template <Orders kOrders, bool kFirst, std::size_t... I>
PLACE_RECOGNITION_INLINE void addTaps(const float* in, std::ptrdiff_t stride,
                                      const float* const* taps, int tap, int n, float* const* out,
                                      std::index_sequence<I...>) {
  const float centre = taps[0][0];
  const float weight[3][sizeof...(I)] = {
      {taps[0][tap + I]...}, {taps[1][tap + I]...}, {taps[2][tap + I]...}};
  const float* const before[] = {in - (tap + static_cast<int>(I)) * stride...};
  const float* const after[] = {in + (tap + static_cast<int>(I)) * stride...};
  float *out_0 = out[0], *out_1 = out[1], *out_2 = out[2];
  PLACE_RECOGNITION_INDEPENDENT
  for (int x = 0; x < n; ++x) {
    const float here = in[x];
    float sum_0 = 0, sum_1 = 0, sum_2 = 0;
    if constexpr (contains(kOrders, 0)) sum_0 = kFirst ? centre * here : out_0[x];
    if constexpr (contains(kOrders, 1) && !kFirst) sum_1 = out_1[x];
    if constexpr (contains(kOrders, 2) && !kFirst) sum_2 = out_2[x];
    ((addTap<kOrders, 0>(weight[0][I], before[I][x], here, after[I][x], sum_0),
      addTap<kOrders, 1>(weight[1][I], before[I][x], here, after[I][x], sum_1),
      addTap<kOrders, 2>(weight[2][I], before[I][x], here, after[I][x], sum_2)),
     ...);
    if constexpr (contains(kOrders, 0)) out_0[x] = sum_0;
    if constexpr (contains(kOrders, 1)) out_1[x] = sum_1;
    if constexpr (contains(kOrders, 2)) out_2[x] = sum_2;
  }
}

/// Number of taps at a time: 8, 6 or 4, so that weights and sums stay in registers.
constexpr int mostTaps(Orders orders) { return 10 - 2 * count(orders); }

template <Orders kOrders, bool kFirst, int kCount = mostTaps(kOrders)>
PLACE_RECOGNITION_INLINE void addUpTo(int count, const float* in, std::ptrdiff_t stride,
                                      const float* const* taps, int tap, int n, float* const* out) {
  if (count >= kCount) {
    addTaps<kOrders, kFirst>(in, stride, taps, tap, n, out, std::make_index_sequence<kCount>());
  } else if constexpr (kCount > 1) {
    addUpTo<kOrders, kFirst, kCount - 1>(count, in, stride, taps, tap, n, out);
  }
}

template <Orders kOrders>
PLACE_RECOGNITION_INLINE void addAll(const float* in, std::ptrdiff_t stride,
                                     const float* const* taps, int half, int n, float* const* out) {
  addUpTo<kOrders, true>(half, in, stride, taps, 1, n, out);
  for (int tap = 1 + mostTaps(kOrders); tap <= half; tap += mostTaps(kOrders)) {
    addUpTo<kOrders, false>(half - tap + 1, in, stride, taps, tap, n, out);
  }
}

template <Orders kOrders = kAllOrders>
PLACE_RECOGNITION_INLINE void addAll(Orders orders, const float* in, std::ptrdiff_t stride,
                                     const float* const* taps, int half, int n, float* const* out) {
  if (orders == kOrders) {
    addAll<kOrders>(in, stride, taps, half, n, out);
  } else if constexpr (kOrders > 1) {
    addAll<kOrders - 1>(orders, in, stride, taps, half, n, out);
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void correlate(Orders orders, const float* in, std::ptrdiff_t stride, const float* const* taps,
               int half, int n, float* const* out) {
  addAll(orders, in, stride, taps, half, n, out);
}

}  // namespace

void correlate(const float* in, std::ptrdiff_t stride, const HalfKernel& kernel, int n,
               float* out) {
  const float* const taps[] = {kernel.taps.data(), kernel.taps.data(), kernel.taps.data()};
  float* const outs[] = {out, out, out};
  correlate(Orders{1} << kernel.order, in, stride, taps, kernel.halfWidth(), n, outs);
}

void correlate(const float* in, std::ptrdiff_t stride, const std::array<HalfKernel, 3>& kernels,
               int n, const std::array<float*, 3>& out) {
  const int half = kernels[0].halfWidth();
  const float* taps[3];
  Orders orders = 0;
  for (int order = 0; order < 3; ++order) {
    assert(kernels[order].order == order && kernels[order].halfWidth() == half);
    taps[order] = kernels[order].taps.data();
    if (out[order]) orders |= Orders{1} << order;
  }
  correlate(orders, in, stride, taps, half, n, out.data());
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
