#include "experiments/plane_drawing.h"

#include <opencv2/imgproc.hpp>

#include "report/svg.h"

namespace place_recognition {
namespace {

constexpr double kGap = 14;
constexpr double kTitle = 20;
constexpr const char* kFrame = "#555";

/// By class, starting near the border.
constexpr const char* kFills[2][DecisionRegions::kLevels.size()] = {
    {"#e3ecf5", "#cfdfee", "#b3cde4", "#94b6d6"}, {"#f9e5e1", "#f4d2cb", "#edb9af", "#e39c8f"}};
constexpr const char* kPoints[2] = {"#1f4e7a", "#9c2f24"};

Region regionOf(const cv::Mat& mask) {
  Region rough, region;
  cv::findContours(mask, rough, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (const auto& contour : rough) {
    cv::approxPolyDP(contour, region.emplace_back(), 0.8, true);
  }
  return region;
}

/// Draws panels with their corner at a given position of a drawing.
class PanelPen {
 public:
  PanelPen(Svg& svg, double left, double top) : svg_(svg), left_(left), top_(top) {}

  void draw(const PlanePanel& panel) {
    constexpr double kSize = DecisionRegions::kSize;
    svg_.text(left_, top_ + kTitle - 7, panel.title);
    svg_.rectangle(left_, top_ + kTitle, kSize, kSize, kFills[1][0]);
    for (std::size_t level = 0; level < DecisionRegions::kLevels.size(); ++level) {
      fill(panel.regions.above[level], kFills[0][level], level == 0 ? kFrame : "none");
      fill(panel.regions.below[level], kFills[1][level], "none");
    }
    for (std::size_t i = 0; i < panel.points->points.size(); ++i) {
      const auto [x, y] = at(*panel.points, i);
      svg_.circle(x, y, 2, kPoints[panel.points->classes[i]]);
    }
    for (const int i : panel.vectors) {
      const auto [x, y] = at(*panel.points, static_cast<std::size_t>(i));
      svg_.ring(x, y, 4.5, "#222");
    }
  }

 private:
  std::pair<double, double> at(const PlanePoints& points, std::size_t i) const {
    const auto& values = std::get<DenseVector>(points.points[i]).values;
    constexpr double kScale = DecisionRegions::kSize / kPlaneSide;
    return {left_ + kScale * values[0], top_ + kTitle + kScale * (kPlaneSide - values[1])};
  }

  void fill(const Region& region, const std::string& colour, const std::string& stroke) {
    if (region.empty()) return;
    std::vector<std::vector<std::pair<double, double>>> rings;
    for (const auto& contour : region) {
      auto& ring = rings.emplace_back();
      for (const cv::Point& corner : contour) {
        ring.emplace_back(left_ + corner.x, top_ + kTitle + corner.y);
      }
    }
    svg_.area(rings, colour, stroke);
  }

  Svg& svg_;
  double left_;
  double top_;
};

}  // namespace

DecisionRegions decisionRegions(const PlanePoints& points, const PlaneMachine& machine) {
  const cv::Mat values = planeValues(points, machine, DecisionRegions::kSize + 1);
  DecisionRegions regions;
  for (std::size_t i = 0; i < DecisionRegions::kLevels.size(); ++i) {
    const double level = DecisionRegions::kLevels[i];
    regions.above[i] = regionOf(values > level);
    if (i > 0) regions.below[i] = regionOf(values < -level);
  }
  return regions;
}

std::string drawPanels(const std::vector<PlanePanel>& panels, std::size_t columns) {
  constexpr double kStep = DecisionRegions::kSize + kGap;
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  Svg svg(static_cast<double>(columns) * kStep + 2,
          static_cast<double>(rows) * (kStep + kTitle) - kGap + 2);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    PanelPen(svg, 1 + static_cast<double>(i % columns) * kStep,
             static_cast<double>(i / columns) * (kStep + kTitle))
        .draw(panels[i]);
  }
  return svg.str();
}

}  // namespace place_recognition
