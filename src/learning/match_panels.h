#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/simd.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// kWidth descriptors interleaved for vector instructions: elements 4k..4k+3 of each, then the next
/// four.
struct alignas(64) DescriptorPanel {
  static constexpr std::size_t kWidth = 32;
  static constexpr std::size_t kSteps = DescriptorSet::kDimension / 4;

  std::uint8_t elements[kSteps][kWidth][4] = {};
  std::int32_t squared_norms[kWidth];     ///< kFar for the padding of a set's last panel
  std::int32_t sums_by_128[kWidth] = {};  ///< 128 times the sum of the elements

  /// Squared norm of padding, which must never be the nearest.
  static constexpr std::int32_t kFar = 1 << 29;

  DescriptorPanel();
  void set(std::size_t lane, const std::uint8_t* descriptor);
  void get(std::size_t lane, std::uint8_t* descriptor) const;
};

/// kRows descriptors, one after another.
struct alignas(64) DescriptorBlock {
  static constexpr std::size_t kRows = 8;

  std::uint8_t elements[kRows][DescriptorSet::kDimension] = {};
  std::int32_t squared_norms[kRows];  ///< kFar for the padding of a set's last block

  DescriptorBlock();
  void set(std::size_t row, const std::uint8_t* descriptor);
};

/// One number for each row of a block and each lane of a panel.
using BlockByPanel = std::int32_t[DescriptorBlock::kRows][DescriptorPanel::kWidth];

/// Finds nearest neighbours between a block and panels: reduces `panel_nearest`, one number per
/// lane of each panel, and `row_nearest` to the squared distances |a|^2 + |b|^2 - 2 a'b, exactly in
/// integers. Each lane has its own nearest distance to a row; the smallest of these is the row's.
using MatchPanels = void(const DescriptorBlock& block, const DescriptorPanel* panels,
                         std::size_t panel_count, BlockByPanel& row_nearest,
                         std::int32_t* panel_nearest);

/// The step that all variants share, given the products a'b of a block and a panel.
PLACE_RECOGNITION_INLINE void lowerNearest(const BlockByPanel& products,
                                           const DescriptorBlock& block,
                                           const DescriptorPanel& panel, BlockByPanel& row_nearest,
                                           std::int32_t* panel_nearest) {
  for (std::size_t r = 0; r < DescriptorBlock::kRows; ++r) {
    for (std::size_t lane = 0; lane < DescriptorPanel::kWidth; ++lane) {
      const std::int32_t distance =
          block.squared_norms[r] + panel.squared_norms[lane] - 2 * products[r][lane];
      const std::int32_t row = row_nearest[r][lane];
      const std::int32_t column = panel_nearest[lane];
      row_nearest[r][lane] = distance < row ? distance : row;
      panel_nearest[lane] = distance < column ? distance : column;
    }
  }
}

/// Portable variant.
MatchPanels matchPanelsPlainly;

#if defined(__x86_64__)
/// Two products of 16-bit numbers per lane and instruction.
MatchPanels matchPanelsAvx2;

/// Four products of 8-bit numbers per lane and instruction.
MatchPanels matchPanelsVnni;
#endif

struct MatchVariant {
  const char* name;
  MatchPanels* match;
};

/// All variants that this processor supports, the fastest last.
std::vector<MatchVariant> matchVariants();

}  // namespace place_recognition
