#include "features/batched_fft.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/simd.h"

namespace place_recognition {

namespace {

using Numbers = BatchedFft::Numbers;

struct Complex {
  float real, imaginary;
};

PLACE_RECOGNITION_INLINE Complex operator+(Complex a, Complex b) {
  return {a.real + b.real, a.imaginary + b.imaginary};
}
PLACE_RECOGNITION_INLINE Complex operator-(Complex a, Complex b) {
  return {a.real - b.real, a.imaginary - b.imaginary};
}
PLACE_RECOGNITION_INLINE Complex operator*(float a, Complex b) {
  return {a * b.real, a * b.imaginary};
}
PLACE_RECOGNITION_INLINE Complex operator*(Complex a, Complex b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}
/// -i a
PLACE_RECOGNITION_INLINE Complex turned(Complex a) { return {a.imaginary, -a.real}; }

// The transforms of 2, 3, 4, 6 and 8 numbers, in place.

PLACE_RECOGNITION_INLINE void transform(Complex (&x)[2]) {
  const Complex sum = x[0] + x[1];
  x[1] = x[0] - x[1];
  x[0] = sum;
}

PLACE_RECOGNITION_INLINE void transform(Complex (&x)[3]) {
  constexpr float kSin = 0.86602540378f;  // of 2 pi / 3
  const Complex sum = x[1] + x[2], difference = turned(kSin * (x[1] - x[2]));
  const Complex middle = x[0] - 0.5f * sum;
  x[0] = x[0] + sum;
  x[1] = middle + difference;
  x[2] = middle - difference;
}

PLACE_RECOGNITION_INLINE void transform(Complex (&x)[4]) {
  const Complex even_sum = x[0] + x[2], even_difference = x[0] - x[2];
  const Complex odd_sum = x[1] + x[3], odd_difference = turned(x[1] - x[3]);
  x[0] = even_sum + odd_sum;
  x[1] = even_difference + odd_difference;
  x[2] = even_sum - odd_sum;
  x[3] = even_difference - odd_difference;
}

/// Decomposed by the Chinese remainder theorem, without twiddles (Good 1958).
PLACE_RECOGNITION_INLINE void transform(Complex (&x)[6]) {
  Complex first[3] = {x[0], x[2], x[4]}, second[3] = {x[3], x[5], x[1]};
  transform(first);
  transform(second);
  for (int k = 0; k < 3; ++k) {
    x[4 * k % 6] = first[k] + second[k];
    x[(4 * k + 3) % 6] = first[k] - second[k];
  }
}

PLACE_RECOGNITION_INLINE void transform(Complex (&x)[8]) {
  constexpr float kCos = 0.70710678119f;  // of pi / 4
  Complex even[4] = {x[0], x[2], x[4], x[6]}, odd[4] = {x[1], x[3], x[5], x[7]};
  transform(even);
  transform(odd);
  odd[1] = kCos * (turned(odd[1]) + odd[1]);
  odd[2] = turned(odd[2]);
  odd[3] = kCos * (turned(odd[3]) - odd[3]);
  for (int k = 0; k < 4; ++k) {
    x[k] = even[k] + odd[k];
    x[k + 4] = even[k] - odd[k];
  }
}

/// Transforms numbers that are `groups` * `stride` apart, multiplies them by `twiddles`, and stores
/// them `stride` apart.
template <int kRadix>
PLACE_RECOGNITION_INLINE void runStep(int groups, int stride, const float* twiddles,
                                      const Numbers* in, Numbers* out) {
  for (int group = 0; group < groups; ++group, twiddles += 2 * (kRadix - 1)) {
    for (int i = 0; i < stride; ++i, ++in, ++out) {
      PLACE_RECOGNITION_INDEPENDENT
      for (int lane = 0; lane < BatchedFft::kLanes; ++lane) {
        Complex x[kRadix];
        for (int k = 0; k < kRadix; ++k) {
          const Numbers& numbers = in[k * groups * stride];
          x[k] = {numbers.real[lane], numbers.imaginary[lane]};
        }
        transform(x);
        for (int k = 0; k < kRadix; ++k) {
          if (k > 0) x[k] = Complex{twiddles[2 * k - 2], twiddles[2 * k - 1]} * x[k];
          out[k * stride].real[lane] = x[k].real;
          out[k * stride].imaginary[lane] = x[k].imaginary;
        }
      }
    }
    out += (kRadix - 1) * stride;
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void runStepOf(int radix, int groups, int stride, const float* twiddles, const Numbers* in,
               Numbers* out) {
  switch (radix) {
    case 2:
      return runStep<2>(groups, stride, twiddles, in, out);
    case 3:
      return runStep<3>(groups, stride, twiddles, in, out);
    case 4:
      return runStep<4>(groups, stride, twiddles, in, out);
    case 6:
      return runStep<6>(groups, stride, twiddles, in, out);
    default:
      return runStep<8>(groups, stride, twiddles, in, out);
  }
}

int withoutFactor(int factor, int n) {
  while (n % factor == 0) n /= factor;
  return n;
}

}  // namespace

int BatchedFft::lengthFrom(int least) {
  int length = std::max(1, least);
  while (withoutFactor(2, withoutFactor(3, length)) != 1) ++length;
  return length;
}

BatchedFft::BatchedFft(int length) {
  int stride = 1;
  for (const int radix : {6, 8, 4, 3, 2}) {
    for (; length % radix == 0; length /= radix, stride *= radix) {
      Step step{radix, length / radix, stride, {}};
      for (int group = 0; group < step.groups; ++group) {
        for (int k = 1; k < radix; ++k) {
          const double angle = -2 * M_PI * group * k / length;
          step.twiddles.push_back(static_cast<float>(std::cos(angle)));
          step.twiddles.push_back(static_cast<float>(std::sin(angle)));
        }
      }
      steps_.push_back(std::move(step));
    }
  }
  assert(length == 1);
}

BatchedFft::Numbers* BatchedFft::transform(Numbers* sequences, Numbers* scratch) const {
  for (const Step& step : steps_) {
    runStepOf(step.radix, step.groups, step.stride, step.twiddles.data(), sequences, scratch);
    std::swap(sequences, scratch);
  }
  return sequences;
}

}  // namespace place_recognition
