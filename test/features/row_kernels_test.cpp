// The vectorized loops against plain ones, bit for bit, with the instruction set in use.
#include "features/row_kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace place_recognition {
namespace {

constexpr int kMargin = 200;  // numbers before and after a row

std::vector<float> randomRow(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> values(-300, 300);
  std::vector<float> row(n + 2 * kMargin);
  for (float& value : row) value = values(random);
  return row;
}

float plainCorrelation(const float* in, int stride, const HalfKernel& kernel) {
  float sum = kernel.order == 0 ? kernel.taps[0] * in[0] : 0;
  for (int r = 1; r <= kernel.halfWidth(); ++r) {
    const float before = in[-r * stride], after = in[r * stride];
    if (kernel.order == 0) sum += kernel.taps[r] * (before + after);
    if (kernel.order == 1) sum += kernel.taps[r] * (after - before);
    if (kernel.order == 2) sum += kernel.taps[r] * ((before + after) - 2 * in[0]);
  }
  return sum;
}

TEST(RowKernels, CorrelateAsPlainSums) {
  for (int half = 1; half <= 20; ++half) {
    for (int order = 0; order <= 2; ++order) {
      const HalfKernel kernel = gaussianKernel(half * half / 9.0, half, order);
      for (int stride : {1, 7}) {
        for (int n : {1, 2, 15, 16, 33, 100}) {
          const std::vector<float> row = randomRow(n, half);
          const float* in = row.data() + kMargin;
          std::vector<float> out(n + 1, 77);
          correlate(in, stride, kernel, n, out.data());
          for (int x = 0; x < n; ++x) ASSERT_EQ(out[x], plainCorrelation(in + x, stride, kernel));
          ASSERT_EQ(out[n], 77);
        }
      }
    }
  }
}

TEST(RowKernels, CorrelateSeveralOrdersAsOneByOne) {
  for (int half = 1; half <= 20; ++half) {
    std::array<HalfKernel, 3> kernels;
    for (int order = 0; order < 3; ++order) {
      kernels[order] = gaussianKernel(half * half / 9.0, half, order);
    }
    for (int stride : {1, 7}) {
      for (int n : {1, 2, 15, 16, 33, 100}) {
        const std::vector<float> row = randomRow(n, half);
        const float* in = row.data() + kMargin;
        for (int wanted = 1; wanted < 8; ++wanted) {
          std::array<std::vector<float>, 3> out;
          std::array<float*, 3> outs{};
          for (int order = 0; order < 3; ++order) {
            out[order].assign(n + 1, 77);
            if (wanted >> order & 1) outs[order] = out[order].data();
          }
          correlate(in, stride, kernels, n, outs);
          for (int order = 0; order < 3; ++order) {
            std::vector<float> alone(n + 1, 77);
            if (outs[order]) correlate(in, stride, kernels[order], n, alone.data());
            ASSERT_EQ(out[order], alone);
          }
        }
      }
    }
  }
}

TEST(RowKernels, CombineDerivativesAsPlainFormulas) {
  const int n = 101;
  const std::vector<float> rows[] = {randomRow(n, 1), randomRow(n, 2), randomRow(n, 3)};
  const float *a = &rows[0][kMargin], *b = &rows[1][kMargin], *c = &rows[2][kMargin];
  std::vector<float> gradient(n), sum(n), determinant(n);
  gradientMagnitude(a, b, n, gradient.data());
  laplacian(a, b, n, sum.data());
  hessianDeterminant(a, b, c, n, determinant.data());
  for (int x = 0; x < n; ++x) {
    EXPECT_EQ(gradient[x], std::sqrt(a[x] * a[x] + b[x] * b[x]));
    EXPECT_EQ(sum[x], a[x] + b[x]);
    EXPECT_EQ(determinant[x], a[x] * c[x] - b[x] * b[x]);
  }
}

TEST(RowKernels, QuantizeAndJoinDigits) {
  const int n = 100;
  std::vector<float> row = randomRow(n, 5);
  float* responses = row.data() + kMargin;
  responses[3] = 1e30f;
  responses[4] = -1e30f;
  responses[5] = 0;
  responses[6] = -1e-30f;
  const Quantizer first{0.1f, 0, -14, 13, 1}, second{0.03f, 0.5f, -7, 7, 28};
  std::vector<std::uint32_t> digits(n);
  quantize(responses, first, false, n, digits.data());
  EXPECT_EQ(digits[3], 27u);
  EXPECT_EQ(digits[4], 0u);
  EXPECT_EQ(digits[5], 14u);
  EXPECT_EQ(digits[6], 13u);
  quantize(responses, second, true, n, digits.data());

  const std::uint64_t weight = (std::uint64_t{1} << 40) + 3;
  std::vector<std::uint64_t> numbers(n);
  joinWord(digits.data(), 1, false, n, numbers.data());
  joinWord(digits.data(), weight, true, n, numbers.data());
  for (int x = 0; x < n; ++x) {
    const auto digit = [&](const Quantizer& q) {
      const float level = std::floor(q.gain * responses[x] + q.offset);
      return static_cast<std::uint64_t>(std::fmin(std::fmax(level, q.lowest), q.highest) -
                                        q.lowest);
    };
    EXPECT_EQ(digits[x], digit(first) + 28 * digit(second));
    EXPECT_EQ(numbers[x], digits[x] * (1 + weight));
  }
}

}  // namespace
}  // namespace place_recognition
