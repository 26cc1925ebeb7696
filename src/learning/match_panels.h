#pragma once

#include <vector>

#include "learning/descriptor_panel.h"

namespace place_recognition {

/// A number for each row of a block and each lane of a panel.
using BlockByPanel = std::int32_t[DescriptorBlock::kRows][DescriptorPanel::kWidth];

/// Finds nearest neighbours between a block and panels: lowers `panel_nearest`, one number a lane
/// of each panel, and `row_nearest` to the squared distances |a|^2 + |b|^2 - 2 a'b, exact in
/// integers. Of a row, each lane keeps its own nearest; the smallest of these is the row's.
using MatchPanels = void(const DescriptorBlock& block, const DescriptorPanel* panels,
                         std::size_t panel_count, BlockByPanel& row_nearest,
                         std::int32_t* panel_nearest);

/// The plain way.
MatchPanels matchPanelsPlainly;

struct MatchVariant {
  const char* name;
  MatchPanels* match;
};

/// All ways that this processor is capable of, the fastest last.
std::vector<MatchVariant> matchVariants();

}  // namespace place_recognition
