#pragma once

#include <cstddef>

namespace place_recognition {

/// out[x] = the sum of weight * in[x + i] over i < `taps`, an even number up to 32: a fused
/// multiply-add for each, in plain loops that the compiler vectorises. Reads in[0..n + taps - 2].
/// All weights are the same, so that they take but one register: the least that can be asked.
void multiplyAdd(const float* in, float weight, int taps, std::size_t n, float* out);

}  // namespace place_recognition
