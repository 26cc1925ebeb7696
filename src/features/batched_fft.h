#pragma once

#include <vector>

namespace place_recognition {

/// Discrete Fourier transforms of kLanes sequences of one length at once. The sequences lie side by
/// side, so that every step works on whole vectors, with the same bits for every instruction set.
class BatchedFft {
 public:
  static constexpr int kLanes = 16;  ///< numbers of 32 bits in the widest vector

  /// One complex number of each sequence.
  struct alignas(64) Numbers {
    float real[kLanes];
    float imaginary[kLanes];
  };

  /// The shortest length from `least` on without prime factors but 2 and 3.
  static int lengthFrom(int least);

  /// `length`: one of those.
  explicit BatchedFft(int length);

  /// X[k] = sum_j x[j] exp(-2 pi i j k / length). `sequences` and `scratch` hold `length` numbers
  /// each. Returns the one of them that holds the transforms, in natural order.
  Numbers* transform(Numbers* sequences, Numbers* scratch) const;

 private:
  /// A step of Stockham's algorithm: `groups` * `stride` transforms of `radix` numbers.
  struct Step {
    int radix, groups, stride;
    std::vector<float> twiddles;  ///< of each group radix - 1 factors: real part, imaginary part
  };

  std::vector<Step> steps_;
};

}  // namespace place_recognition
