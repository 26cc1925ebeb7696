#include "evaluation/plots.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "report/fraction_plot.h"
#include "report/svg.h"

namespace place_recognition {

using namespace plot_colours;

std::string ratesPlot(const Summary& summary) {
  constexpr double kLeft = 200, kWidth = 560, kRow = 26;
  const double height = kRow * static_cast<double>(summary.rooms.size());
  Svg svg(900, height + 30);
  for (int i = 0; i <= 5; ++i) {
    const double x = kLeft + kWidth * i / 5;
    svg.line(x, 0, x, height, kGrid);
    svg.text(x, height + 16, std::to_string(20 * i) + " %", "middle");
  }
  double y = 4;
  for (const RoomSummary& room : summary.rooms) {
    const std::string& name = summary.places[static_cast<std::size_t>(room.place)];
    const std::string label = percent(room.rate()) + " of " + std::to_string(room.count);
    svg.text(kLeft - 8, y + 14, name, "end");
    svg.rectangle(kLeft, y, kWidth * room.rate(), kRow - 8, kBlue, name + ": " + label);
    svg.text(kLeft + kWidth + 12, y + 14, label);
    y += kRow;
  }
  const double mean = kLeft + kWidth * summary.average_rate;
  svg.line(mean, 0, mean, height, kRed);
  return svg.str();
}

std::string reliabilityPlot(const Summary& summary) {
  FractionPlot plot("confidence", "right");
  plot.svg().line(plot.x(0), plot.y(0), plot.x(1), plot.y(1), kDark);
  std::vector<std::pair<double, double>> curve;
  std::uint64_t most = 1;
  for (const ReliabilityBin& bin : summary.reliability) most = std::max(most, bin.count);
  for (const ReliabilityBin& bin : summary.reliability) {
    if (bin.count == 0) continue;
    curve.emplace_back(plot.x(bin.confidence), plot.y(bin.rate));
  }
  plot.svg().polyline(curve, kBlue);
  for (const ReliabilityBin& bin : summary.reliability) {
    if (bin.count == 0) continue;
    const double radius = 3 + 6 * static_cast<double>(bin.count) / static_cast<double>(most);
    plot.svg().circle(plot.x(bin.confidence), plot.y(bin.rate), radius, kBlue,
                      counted(bin.count, "image") + ", " + percent(bin.rate) + " right");
  }
  return plot.svg().str();
}

std::string confidencePlot(const Evaluation& evaluation) {
  constexpr int kBins = 20;
  std::array<double, kBins> right{}, wrong{};
  for (const FrameResult& frame : evaluation.frames) {
    if (!evaluation.learned(frame)) continue;
    const int bin = std::clamp(static_cast<int>(frame.confidence * kBins), 0, kBins - 1);
    (frame.correct() ? right : wrong)[static_cast<std::size_t>(bin)] += 1;
  }
  double most = 1;
  for (std::size_t i = 0; i < kBins; ++i) most = std::max(most, right[i] + wrong[i]);

  FractionPlot plot("confidence", "images of the fullest bin");
  const double width = plot.x(1.0 / kBins) - plot.x(0) - 2;
  for (std::size_t i = 0; i < kBins; ++i) {
    const double x = plot.x(static_cast<double>(i) / kBins) + 1;
    const double middle = plot.y(right[i] / most), top = plot.y((right[i] + wrong[i]) / most);
    plot.svg().rectangle(x, middle, width, plot.y(0) - middle, kBlue,
                         fixed(right[i], 0) + " right");
    plot.svg().rectangle(x, top, width, middle - top, kRed, fixed(wrong[i], 0) + " wrong");
  }
  return plot.svg().str();
}

std::string riskPlot(const Summary& summary) {
  FractionPlot plot("images answered, most confident first", "wrong");
  std::vector<std::pair<double, double>> curve;
  for (const RiskPoint& point : summary.risk_coverage) {
    curve.emplace_back(plot.x(point.coverage), plot.y(point.risk));
  }
  plot.svg().polyline(curve, kRed);
  return plot.svg().str();
}

std::string rocPlot(const UnknownSummary& unknown) {
  FractionPlot plot("known places called unknown", "unknown places found");
  plot.svg().line(plot.x(0), plot.y(0), plot.x(1), plot.y(1), kDark);
  std::vector<std::pair<double, double>> curve;
  for (const RocPoint& point : unknown.roc) {
    curve.emplace_back(plot.x(point.positive_below), plot.y(point.negative_below));
  }
  plot.svg().polyline(curve, kBlue);
  plot.svg().circle(plot.x(unknown.false_alarm_rate), plot.y(unknown.detection_rate), 4, kRed,
                    "at the model's threshold");
  return plot.svg().str();
}

}  // namespace place_recognition
