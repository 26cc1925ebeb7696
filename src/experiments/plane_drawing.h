#pragma once

#include <array>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

#include "experiments/plane_problem.h"

namespace place_recognition {

/// The region in which a discriminant function exceeds a level, as polygons in pixels; polygons
/// inside another one are holes.
using Region = std::vector<std::vector<cv::Point>>;

struct DecisionRegions {
  static constexpr int kSize = 220;  ///< sides of the drawing, pixels
  static constexpr std::array<double, 4> kLevels = {0, 0.5, 1, 2};

  std::array<Region, kLevels.size()> above;  ///< f > level
  std::array<Region, kLevels.size()> below;  ///< f < -level; the first is empty
};

DecisionRegions decisionRegions(const PlanePoints& points, const PlaneMachine& machine);

/// One panel of a figure.
struct PlanePanel {
  std::string title;
  const PlanePoints* points;
  std::vector<int> vectors;  ///< circled points
  DecisionRegions regions;
};

/// Panels in rows of `columns`, as an SVG drawing. Hue shows the sign of the discriminant function,
/// and saturation its value.
std::string drawPanels(const std::vector<PlanePanel>& panels, std::size_t columns);

}  // namespace place_recognition
