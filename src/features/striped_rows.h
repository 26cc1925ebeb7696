#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

/// A row of pixels cut into lanes of equal length that lie side by side: pixel k * length + i of
/// the row, which is pixel i of lane k, stands at i * kLanes + k. A step along the row is a
/// step of kLanes numbers in memory then, for all lanes at once: a filter along the row reads
/// whole vectors from where vectors begin, as filters down the columns do (with AVX-512 in little
/// more than half the time). What stands beyond the row's last pixel, in the last lanes, is
/// padding.
class StripedRows {
 public:
  static constexpr int kLanes = 16;  ///< numbers of 32 bits in the widest vector

  explicit StripedRows(int pixels = 0) : length_((pixels + kLanes - 1) / kLanes) {}

  /// Numbers in a row, padding included.
  int size() const { return kLanes * length_; }

  /// Cuts a row of size() numbers.
  void lay(const float* row, float* lanes) const;
  /// Lengthens each lane by the first n pixels of what follows it: size() numbers become
  /// size() + n * kLanes. The last lane is lengthened by padding.
  void lengthen(int n, float* lanes) const;
  /// The first `pixels` pixels of the row, in the order of the lanes and without padding. `row`
  /// has room for size() numbers and may be `lanes`.
  void take(int pixels, const std::uint32_t* lanes, std::uint32_t* row) const;

 private:
  int length_;
};

}  // namespace place_recognition
