#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "features/gaussian.h"

/// The inner loops of dense features. Each maps rows of n numbers to a row of n numbers that must
/// not overlap them. They are vectorized for the instruction set found at run time, with the same
/// bits on all.
namespace place_recognition {

/// Correlates with a symmetric or antisymmetric kernel: along a row if `stride` is 1, along a
/// column if it is the distance between rows. Reads in[x + r * stride] for every tap -half..half
/// and x in 0..n-1. Kernels of order 1 and 2 give exactly zero where the image is constant.
void correlate(const float* in, std::ptrdiff_t stride, const HalfKernel& kernel, int n, float* out);

/// The same with the kernels of orders 0, 1 and 2, all of the same half-width, into out[order], or
/// skipped if that is null. Gives the same bits as separate calls in less time, because the kernels
/// share the samples.
void correlate(const float* in, std::ptrdiff_t stride, const std::array<HalfKernel, 3>& kernels,
               int n, const std::array<float*, 3>& out);

/// sqrt(x^2 + y^2), thesis eq. 4.17.
void gradientMagnitude(const float* x, const float* y, int n, float* out);
/// xx + yy, eq. 4.22.
void laplacian(const float* xx, const float* yy, int n, float* out);
/// xx yy - xy^2, eq. 4.20.
void hessianDeterminant(const float* xx, const float* xy, const float* yy, int n, float* out);

/// Maps a response to one digit of a mixed-radix number: level = floor(gain * response + offset),
/// clamped to lowest..highest, all integers; the digit, level - lowest, is multiplied by `weight`.
/// With 0 <= offset < 1 no response is lost in rounding, however close to zero.
struct Quantizer {
  float gain;
  float offset;
  float lowest;
  float highest;
  std::uint32_t weight;
};
/// index[x] = weight * digit, or += if `add`.
void quantize(const float* response, const Quantizer& quantizer, bool add, int n,
              std::uint32_t* index);

/// Combines words of digits to one number: number[x] = weight * digits[x], or += if `add`.
void joinWord(const std::uint32_t* digits, std::uint64_t weight, bool add, int n,
              std::uint64_t* number);

}  // namespace place_recognition
