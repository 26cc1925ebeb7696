#pragma once

#include <cstddef>
#include <cstdint>

namespace place_recognition {

/// A row of pixels divided into lanes of equal length that are interleaved: pixel k * length + i of
/// the row, which is pixel i of lane k, is stored at i * kLanes + k (Farrar's striped layout). One
/// step along the row is then a step of kLanes numbers in memory, for all lanes at once. A filter
/// along the row thus reads whole aligned vectors, as filters along the columns do (with AVX-512 in
/// little more than half the time). The numbers after the row's last pixel, in the last lanes, are
/// padding.
class StripedRows {
 public:
  static constexpr int kLanes = 16;  ///< 32-bit numbers in the widest vector

  explicit StripedRows(int pixels = 0) : length_((pixels + kLanes - 1) / kLanes) {}

  /// Numbers in a row, including padding.
  int size() const { return kLanes * length_; }

  /// Divides a row of size() numbers into lanes.
  void lay(const float* row, float* lanes) const;
  /// Extends each lane by the first n pixels of the next lane: size() numbers become size() + n *
  /// kLanes. The last lane is extended by padding.
  void lengthen(int n, float* lanes) const;
  /// Restores the first `pixels` pixels of the row from the lanes, without padding. `row` has room
  /// for size() numbers and may equal `lanes`.
  void take(int pixels, const std::uint32_t* lanes, std::uint32_t* row) const;

 private:
  int length_;
};

}  // namespace place_recognition
