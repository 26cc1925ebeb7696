#include "features/striped_rows.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "base/simd.h"

namespace place_recognition {
namespace {

constexpr int kStrands = StripedRows::kStrands;

PLACE_RECOGNITION_TARGET_CLONES
void transpose(const float* __restrict row, int length, float* __restrict strands) {
  for (int i = 0; i < length; ++i) {
    for (int k = 0; k < kStrands; ++k) strands[i * kStrands + k] = row[k * length + i];
  }
}

}  // namespace

void StripedRows::lay(const float* row, float* strands) const { transpose(row, length_, strands); }

void StripedRows::lengthen(int n, float* strands) const {
  // What follows pixel i of strand k at its end is pixel i of strand k + 1, which stands beside it.
  // No more at a time than there is, where strands are shorter than n.
  assert(length_ > 0);
  for (int done = 0; done < n; done += length_) {
    const int numbers = std::min(length_, n - done) * kStrands;
    const float* from = strands + done * kStrands;
    float* to = strands + done * kStrands + size();
    std::copy(from + 1, from + numbers, to);
    to[numbers - 1] = 0;
  }
}

void StripedRows::take(int pixels, const std::uint32_t* strands, std::uint32_t* row) const {
  assert(pixels > 0 && pixels <= size());
  const int whole = (pixels - 1) / length_;  // strands; one more has `rest` pixels
  const int rest = pixels - whole * length_;
  for (int i = 0; i < length_; ++i) {
    std::uint32_t beside[kStrands];
    std::memcpy(beside, strands + i * kStrands, sizeof(beside));
    std::memcpy(row, beside, sizeof(beside));
    row += i < rest ? whole + 1 : whole;
  }
}

}  // namespace place_recognition
