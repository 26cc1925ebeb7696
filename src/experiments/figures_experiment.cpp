#include "experiments/experiments.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "base/options.h"
#include "base/text.h"
#include "experiments/plane_drawing.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

/// Removes vectors that depend on others up to rounding.
constexpr double kExact = 1e-8;

/// A machine of one panel; tau 0 means before reduction.
struct Panel {
  std::string title;
  KernelOptions kernel;
  double c = 100;
  double tau = 0;
};

struct FigurePlan {
  const char* name;
  const char* title;
  PlaneBorder border;
  std::size_t columns;
  std::vector<Panel> panels;
};

KernelOptions gaussian(double gamma) {
  KernelOptions kernel;
  kernel.type = "gaussian";
  kernel.gamma = gamma;
  return kernel;
}

KernelOptions ofType(const char* type) {
  KernelOptions kernel;
  kernel.type = type;
  kernel.gamma = 5;
  return kernel;
}

KernelOptions sigmoid() {
  KernelOptions kernel = ofType("sigmoid");
  kernel.kappa = 0.3;
  kernel.theta = -1.5;
  return kernel;
}

/// Chapter 5: the effects of C and of the kernel; chapter 6: reduction up to rounding, and by tau.
std::vector<FigurePlan> figurePlans() {
  FigurePlan by_c{
      "figure_5_5", "Figure 5.5: Gaussian kernel, gamma = 5", PlaneBorder::kWave, 3, {}};
  for (const double c : {1, 100, 1000}) {
    by_c.panels.push_back({"C = " + significant(c), gaussian(5), c});
  }
  FigurePlan by_kernel{"kernels", "Kernels, C = 100", PlaneBorder::kWave, 3, {}};
  for (const char* type : {"linear", "polynomial", "gaussian", "chi-squared", "intersection"}) {
    by_kernel.panels.push_back({type, ofType(type)});
  }
  by_kernel.panels.push_back({"sigmoid", sigmoid()});
  FigurePlan exact{
      "figure_6_1", "Figure 6.1: reduction up to rounding, C = 100", PlaneBorder::kLine, 3, {}};
  for (const double tau : {0.0, kExact}) {
    for (const char* type : {"linear", "polynomial", "gaussian"}) {
      const KernelOptions kernel = *type == 'g' ? gaussian(0.5) : ofType(type);
      exact.panels.push_back({type, kernel, 100, tau});
    }
  }
  FigurePlan by_tau{
      "figure_6_2", "Figure 6.2: Gaussian kernel, gamma = 0.5, C = 100", PlaneBorder::kWave, 2, {}};
  for (const double tau : {0.0, 1e-6, 1e-4, 1e-3}) {
    by_tau.panels.push_back(
        {tau > 0 ? "tau = " + significant(tau) : "not reduced", gaussian(0.5), 100, tau});
  }
  return {by_c, by_kernel, exact, by_tau};
}

Json toJson(const Region& region) {
  Json polygons = Json::array();
  for (const auto& contour : region) {
    Json polygon = Json::array();
    for (const cv::Point& corner : contour) polygon.push_back({corner.x, corner.y});
    polygons.push_back(polygon);
  }
  return polygons;
}

Region regionFromJson(const Json& polygons) {
  Region region;
  for (const Json& polygon : polygons) {
    auto& contour = region.emplace_back();
    for (const Json& corner : polygon) contour.emplace_back(corner.at(0), corner.at(1));
  }
  return region;
}

Json cellOf(const FigurePlan& figure, const Panel& panel) {
  return {{"figure", figure.name},
          {"kernel", writeOptions(panel.kernel)},
          {"c", panel.c},
          {"tau", panel.tau}};
}

/// The machine of a panel, its number of vectors before reduction, and the largest change of the
/// discriminant function in the square.
Json evaluate(PlaneBorder border, const Panel& panel) {
  const PlanePoints points = planePoints(border);
  const PlaneMachine trained = trainInPlane(points, panel.kernel, panel.c);
  PlaneMachine machine = trained;
  double change = 0;
  if (panel.tau > 0) {
    machine = reduceInPlane(points, trained, panel.tau);
    constexpr int kGrid = 50;
    change = cv::norm(planeValues(points, machine, kGrid), planeValues(points, trained, kGrid),
                      cv::NORM_INF);
  }
  const DecisionRegions regions = decisionRegions(points, machine);
  Json result = {
      {"before", trained.vectors.size()}, {"vectors", machine.vectors}, {"change", change}};
  for (const Region& region : regions.above) result["above"].push_back(toJson(region));
  for (const Region& region : regions.below) result["below"].push_back(toJson(region));
  return result;
}

PlanePanel panelFromJson(const std::string& title, const PlanePoints& points, const Json& json) {
  PlanePanel panel{title, &points, json.at("vectors"), {}};
  for (std::size_t i = 0; i < DecisionRegions::kLevels.size(); ++i) {
    panel.regions.above[i] = regionFromJson(json.at("above").at(i));
    panel.regions.below[i] = regionFromJson(json.at("below").at(i));
  }
  const std::string vectors = std::to_string(panel.vectors.size());
  const bool reduced = panel.vectors.size() < json.at("before").get<std::size_t>();
  panel.title +=
      ": " + vectors + (reduced ? " of " + json.at("before").dump() : " support vectors");
  return panel;
}

class FiguresExperiment : public Experiment {
 public:
  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const FigurePlan& figure : figurePlans()) {
      for (const Panel& panel : figure.panels) cells.push_back(cellOf(figure, panel));
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    std::size_t next = 0;  // cells are in the order of cells()
    for (const FigurePlan& figure : figurePlans()) {
      for (const Panel& panel : figure.panels) {
        if (next == cells.size() || cellOf(figure, panel) != cells[next]) continue;
        report(progress, "Drawing", static_cast<double>(next) / static_cast<double>(cells.size()));
        finished(cells[next++], evaluate(figure.border, panel));
      }
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    Findings findings;
    std::size_t next = 0;
    for (const FigurePlan& figure : figurePlans()) {
      const PlanePoints points = planePoints(figure.border);
      Table table{figure.name,
                  figure.title,
                  {{"panel", "C", "tau", "support vectors", "kept", "largest change of f"}}};
      std::vector<PlanePanel> panels;
      for (const Panel& panel : figure.panels) {
        const Json& result = results[next++];
        panels.push_back(panelFromJson(panel.title, points, result));
        table.rows.push_back(
            {panel.title, significant(panel.c), significant(panel.tau), result.at("before").dump(),
             std::to_string(result.at("vectors").size()), significant(result.at("change"))});
      }
      findings.tables.push_back(table);
      findings.figures.push_back({figure.name, drawPanels(panels, figure.columns)});
    }
    return findings;
  }
};

}  // namespace

std::unique_ptr<Experiment> figuresExperiment() { return std::make_unique<FiguresExperiment>(); }

}  // namespace place_recognition
