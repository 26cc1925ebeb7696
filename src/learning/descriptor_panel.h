#pragma once

#include <cstddef>
#include <cstdint>

#include "place_recognition/feature.h"

namespace place_recognition {

/// kWidth descriptors side by side, as vector instructions want them: elements 4k..4k+3 of each,
/// then the next four.
struct alignas(64) DescriptorPanel {
  static constexpr std::size_t kWidth = 32;
  static constexpr std::size_t kSteps = DescriptorSet::kDimension / 4;

  std::uint8_t elements[kSteps][kWidth][4] = {};
  std::int32_t squared_norms[kWidth];     ///< kFar for what fills up the last panel of a set
  std::int32_t sums_by_128[kWidth] = {};  ///< 128 times the sum of the elements

  /// Squared norm of a descriptor that must never be the nearest.
  static constexpr std::int32_t kFar = 1 << 29;

  DescriptorPanel();
  void set(std::size_t lane, const std::uint8_t* descriptor);
  void get(std::size_t lane, std::uint8_t* descriptor) const;
};

/// kRows descriptors one after the other.
struct alignas(64) DescriptorBlock {
  static constexpr std::size_t kRows = 8;

  std::uint8_t elements[kRows][DescriptorSet::kDimension] = {};
  std::int32_t squared_norms[kRows];  ///< kFar for what fills up the last block of a set

  DescriptorBlock();
  void set(std::size_t row, const std::uint8_t* descriptor);
};

}  // namespace place_recognition
