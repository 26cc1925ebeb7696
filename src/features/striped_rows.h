#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

/// A row of pixels cut into strands of equal length that lie side by side: pixel k * length + i of
/// the row, which is pixel i of strand k, stands at i * kStrands + k. A step along the row is a
/// step of kStrands numbers in memory then, for all strands at once: a filter along the row reads
/// whole vectors from where vectors begin, as filters down the columns do (with AVX-512 in little
/// more than half the time). What stands beyond the row's last pixel, in the last strands, is
/// padding.
class StripedRows {
 public:
  static constexpr int kStrands = 16;  ///< numbers of 32 bits in the widest vector

  explicit StripedRows(int pixels = 0) : length_((pixels + kStrands - 1) / kStrands) {}

  /// Numbers in a row, padding included.
  int size() const { return kStrands * length_; }

  /// Cuts a row of size() numbers.
  void lay(const float* row, float* strands) const;
  /// Lengthens each strand by the first n pixels of what follows it: size() numbers become
  /// size() + n * kStrands. The last strand is lengthened by padding.
  void lengthen(int n, float* strands) const;
  /// The first `pixels` pixels of the row, in the order of the strands and without padding. `row`
  /// has room for size() numbers and may be `strands`.
  void take(int pixels, const std::uint32_t* strands, std::uint32_t* row) const;

 private:
  int length_;
};

}  // namespace place_recognition
