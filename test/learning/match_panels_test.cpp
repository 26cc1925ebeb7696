#include "learning/match_panels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "learning/random_features.h"

namespace place_recognition {
namespace {

constexpr std::size_t kRows = DescriptorBlock::kRows;
constexpr std::size_t kWidth = DescriptorPanel::kWidth;

std::int32_t squaredDistance(const std::uint8_t* a, const std::uint8_t* b) {
  std::int32_t sum = 0;
  for (std::size_t k = 0; k < DescriptorSet::kDimension; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// Expects that every way of matching finds the exact nearest distances between two sets of
/// descriptors.
void expectNearest(const DescriptorSet& a, const DescriptorSet& b) {
  DescriptorBlock block;
  for (std::size_t i = 0; i < a.size(); ++i) block.set(i, a.row(i));
  std::vector<DescriptorPanel> panels((b.size() + kWidth - 1) / kWidth);
  for (std::size_t j = 0; j < b.size(); ++j) panels[j / kWidth].set(j % kWidth, b.row(j));

  for (const MatchVariant& variant : matchVariants()) {
    BlockByPanel row_nearest;
    std::fill_n(&row_nearest[0][0], kRows * kWidth, DescriptorPanel::kFar);
    std::vector<std::int32_t> panel_nearest(panels.size() * kWidth, DescriptorPanel::kFar);
    variant.match(block, panels.data(), panels.size(), row_nearest, panel_nearest.data());

    for (std::size_t i = 0; i < a.size(); ++i) {
      std::int32_t expected = DescriptorPanel::kFar;
      for (std::size_t j = 0; j < b.size(); ++j) {
        expected = std::min(expected, squaredDistance(a.row(i), b.row(j)));
      }
      EXPECT_EQ(*std::min_element(row_nearest[i], row_nearest[i] + kWidth), expected)
          << variant.name << " row " << i;
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::int32_t expected = DescriptorPanel::kFar;
      for (std::size_t i = 0; i < a.size(); ++i) {
        expected = std::min(expected, squaredDistance(a.row(i), b.row(j)));
      }
      EXPECT_EQ(panel_nearest[j], expected) << variant.name << " lane " << j;
    }
  }
}

TEST(MatchPanels, EveryVariantIsExact) {
  RandomFeatures random(11);
  for (const std::size_t rows : {std::size_t{1}, std::size_t{3}, kRows}) {
    for (const std::size_t lanes : {std::size_t{1}, kWidth - 1, kWidth, 2 * kWidth + 5}) {
      expectNearest(random.descriptors(rows), random.descriptors(lanes));
    }
  }
}

TEST(MatchPanels, EveryVariantIsExactAtTheEndsOfTheRange) {
  DescriptorSet black;
  black.descriptors.assign(kRows * DescriptorSet::kDimension, 0);
  DescriptorSet white;
  white.descriptors.assign(kRows * DescriptorSet::kDimension, 255);
  expectNearest(black, white);
  expectNearest(white, white);
  expectNearest(white, black);
}

}  // namespace
}  // namespace place_recognition
