#include "features/striped_rows.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "base/simd.h"

namespace place_recognition {
namespace {

constexpr int kLanes = StripedRows::kLanes;

PLACE_RECOGNITION_TARGET_CLONES
void transpose(const float* __restrict row, int length, float* __restrict lanes) {
  for (int i = 0; i < length; ++i) {
    for (int k = 0; k < kLanes; ++k) lanes[i * kLanes + k] = row[k * length + i];
  }
}

}  // namespace

void StripedRows::lay(const float* row, float* lanes) const { transpose(row, length_, lanes); }

void StripedRows::lengthen(int n, float* lanes) const {
  // The pixel that follows the end of lane k is pixel i of lane k + 1, which is stored beside it.
  // If lanes are shorter than n, copy only as many pixels at a time as a lane has.
  assert(length_ > 0);
  for (int done = 0; done < n; done += length_) {
    const int numbers = std::min(length_, n - done) * kLanes;
    const float* from = lanes + done * kLanes;
    float* to = lanes + done * kLanes + size();
    std::copy(from + 1, from + numbers, to);
    to[numbers - 1] = 0;
  }
}

void StripedRows::take(int pixels, const std::uint32_t* lanes, std::uint32_t* row) const {
  assert(pixels > 0 && pixels <= size());
  const int whole = (pixels - 1) / length_;  // complete lanes; one more has `rest` pixels
  const int rest = pixels - whole * length_;
  for (int i = 0; i < length_; ++i) {
    std::uint32_t beside[kLanes];
    std::memcpy(beside, lanes + i * kLanes, sizeof(beside));
    std::memcpy(row, beside, sizeof(beside));
    row += i < rest ? whole + 1 : whole;
  }
}

}  // namespace place_recognition
