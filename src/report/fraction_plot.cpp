#include "report/fraction_plot.h"

#include <array>

#include "base/text.h"

namespace place_recognition {

using namespace plot_colours;

FractionPlot::FractionPlot(const std::string& x_label, const std::string& y_label)
    : svg_(360, 300) {
  for (int i = 0; i <= 5; ++i) {
    const double fraction = i / 5.0;
    svg_.line(x(fraction), y(0), x(fraction), y(1), kGrid);
    svg_.line(x(0), y(fraction), x(1), y(fraction), kGrid);
    svg_.text(x(fraction), y(0) + 16, fixed(100 * fraction, 0), "middle");
    svg_.text(x(0) - 6, y(fraction) + 4, fixed(100 * fraction, 0), "end");
  }
  svg_.text(x(0.5), y(0) + 34, x_label + ", %", "middle");
  svg_.text(4, y(1) - 13, y_label + ", %");
}

std::string fractionsPlot(const std::string& x_label, const std::string& y_label,
                          const std::vector<Curve>& curves) {
  constexpr std::array<const char*, 4> kColours = {kBlue, kRed, kGreen, kDark};
  FractionPlot plot(x_label, y_label);
  double y = plot.y(0) - 12;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const char* const colour = kColours[i % kColours.size()];
    std::vector<std::pair<double, double>> line;
    for (const auto& [px, py] : curves[i].points) line.emplace_back(plot.x(px), plot.y(py));
    plot.svg().polyline(line, colour);
    plot.svg().rectangle(plot.x(0.62), y - 9, 10, 10, colour);
    plot.svg().text(plot.x(0.62) + 16, y, curves[i].name);
    y -= 16;
  }
  return plot.svg().str();
}

}  // namespace place_recognition
