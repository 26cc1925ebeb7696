#pragma once

#include <vector>

namespace place_recognition {

/// Computes the discrete Fourier transforms of kLanes sequences of equal length at once. The
/// sequences are interleaved, so every step uses whole vectors; results are bit-identical for all
/// instruction sets.
class BatchedFft {
 public:
  static constexpr int kLanes = 16;  ///< 32-bit numbers in the widest vector

  /// One complex number of each sequence.
  struct alignas(64) Numbers {
    float real[kLanes];
    float imaginary[kLanes];
  };

  /// The smallest length >= `least` whose only prime factors are 2 and 3.
  static int lengthFrom(int least);

  /// `length`: its only prime factors are 2 and 3.
  explicit BatchedFft(int length);

  /// X[k] = sum_j x[j] exp(-2 pi i j k / length). `sequences` and `scratch` hold `length` numbers
  /// each. Returns whichever of the two holds the transforms, in natural order.
  Numbers* transform(Numbers* sequences, Numbers* scratch) const;

 private:
  /// A step of Stockham's algorithm: `groups` * `stride` transforms of `radix` numbers.
  struct Step {
    int radix, groups, stride;
    std::vector<float> twiddles;  ///< radix - 1 factors per group: real part, imaginary part
  };

  std::vector<Step> steps_;
};

}  // namespace place_recognition
