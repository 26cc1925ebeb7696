#pragma once

#include "base/simd.h"
#include "learning/match_panels.h"

namespace place_recognition {

/// What every way of matching does with the products a'b of a block and a panel.
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

}  // namespace place_recognition
