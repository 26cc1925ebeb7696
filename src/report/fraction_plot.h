#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/svg.h"

namespace place_recognition {

namespace plot_colours {
constexpr const char* kBlue = "#3b6ea5";
constexpr const char* kRed = "#c0504d";
constexpr const char* kGreen = "#6a994e";
constexpr const char* kGrid = "#ddd";
constexpr const char* kDark = "#888";
}  // namespace plot_colours

/// A square plot of one fraction (0..1) against another, with its axes in %.
class FractionPlot {
 public:
  FractionPlot(const std::string& x_label, const std::string& y_label);

  /// Pixel coordinates of a fraction.
  double x(double fraction) const { return 44 + 300 * fraction; }
  double y(double fraction) const { return 250 - 225 * fraction; }

  Svg& svg() { return svg_; }

 private:
  Svg svg_;
};

/// Points (fraction, fraction), 0..1, connected in order.
struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

/// Several curves in one square plot, with their names.
std::string fractionsPlot(const std::string& x_label, const std::string& y_label,
                          const std::vector<Curve>& curves);

}  // namespace place_recognition
