#include "experiments/materials_tables.h"

#include <cmath>

#include "base/text.h"
#include "experiments/thesis_materials.h"
#include "report/share_plot.h"

namespace place_recognition {
namespace {

std::string plusMinus(const std::vector<double>& values, int decimals) {
  const Spread spread = spreadOf(values);
  return fixed(spread.mean, decimals) + " +- " + fixed(spread.deviation, decimals);
}

/// Rate and vectors before reduction, and what is dropped at each share of the rate.
std::vector<std::string> measured(const MaterialResult& result) {
  std::vector<double> rates, vectors;
  for (const auto& curves : result.curves) {
    rates.push_back(100 * curves[0][0].rate);
    vectors.push_back(curves[0][0].vectors);
  }
  std::vector<std::string> cells = {plusMinus(rates, 2), plusMinus(vectors, 0)};
  for (const int share : kMaterialShares) {
    std::vector<double> dropped;
    for (const auto& curves : result.curves) {
      const double all = std::max(1, curves[0][0].vectors);
      dropped.push_back(100 - 100 * fewestVectors(curves, share / 100.0) / all);
    }
    cells.push_back(plusMinus(dropped, 2));
  }
  return cells;
}

std::vector<std::string> printed(const ThesisMaterial& thesis) {
  std::vector<std::string> cells = {
      "| " + thesis.kernel, fixed(thesis.rate, 2) + " +- " + fixed(thesis.rate_deviation, 2),
      std::to_string(thesis.vectors)};
  for (const double reduction : thesis.reduction) cells.push_back(fixed(reduction, 2));
  return cells;
}

bool isNear(double a, double b) { return std::abs(a - b) < 1e-6 * b; }

/// Whether a classifier is of the kind that row `row` of a table is about.
bool belongs(const MaterialClassifier& classifier, const ThesisMaterialTable& table,
             std::size_t row) {
  if (classifier.feature != table.feature || classifier.svm.multiclass != table.multiclass) {
    return false;
  }
  const std::string number = table.number;
  const auto power = static_cast<double>(row);
  if (number == "7.1") {
    return classifier.svm.c == 100 && classifier.kernel.type == "gaussian" &&
           isNear(classifier.kernel.gamma, std::pow(10, power - 3));
  }
  if (number == "7.2") {
    return classifier.kernel.type == "gaussian" && isNear(classifier.kernel.gamma, 0.01) &&
           isNear(classifier.svm.c, std::pow(10, power));
  }
  static constexpr const char* kTypes[] = {"chi-squared", "gaussian", "polynomial", "polynomial"};
  return classifier.svm.c == 100 && classifier.kernel.type == kTypes[row] &&
         (row < 2 || classifier.kernel.p == (row == 2 ? 0 : 1));
}

/// The classifier of a row: the best one by validation of those that belong there.
const MaterialResult* chosen(const std::vector<MaterialResult>& results,
                             const ThesisMaterialTable& table, std::size_t row) {
  const MaterialResult* best = nullptr;
  for (const MaterialResult& result : results) {
    if (!belongs(result.classifier, table, row)) continue;
    if (!best || result.validation > best->validation) best = &result;
  }
  return best;
}

std::string label(const MaterialResult& result, const std::string& table) {
  if (table != "7.2") return describe(result.classifier.kernel);
  return "C=" + fixed(result.classifier.svm.c, 0);
}

Table materialTable(const std::vector<MaterialResult>& results, const ThesisMaterialTable& thesis) {
  Table table;
  const std::string number = thesis.number;
  table.name = "table_7_" + number.substr(2);
  table.title =
      "Table " + number + ": " + thesis.feature + ", " + thesis.multiclass +
      ". Rate, vectors, and per cent of them dropped while keeping a share of the rate; "
      "mean +- standard deviation over the tested samples; right, the thesis on KTH-TIPS2";
  std::vector<std::string>& head =
      table.rows.emplace_back(std::vector<std::string>{"classifier", "rate, %", "vectors"});
  const auto addShares = [&head] {
    for (const int share : kMaterialShares) head.push_back("at " + std::to_string(share) + " %");
  };
  addShares();
  for (const char* column : {"| classifier", "rate, %", "vectors"}) head.emplace_back(column);
  addShares();
  for (std::size_t i = 0; i < thesis.rows.size(); ++i) {
    const MaterialResult* const result = chosen(results, thesis, i);
    std::vector<std::string>& row =
        table.rows.emplace_back(std::vector<std::string>{label(*result, number)});
    for (const auto& cells : {measured(*result), printed(thesis.rows[i])}) {
      row.insert(row.end(), cells.begin(), cells.end());
    }
  }
  return table;
}

/// Rate against vectors left, mean over the tested samples, normalized.
Curve rateCurve(const std::string& name, const MaterialResult& result) {
  std::vector<ReductionCurve> curves;
  for (const auto& both : result.curves) curves.push_back(both[0]);
  return {name, meanCurve(curves)};
}

/// Share of vectors dropped against tau, mean over the tested samples.
Curve tauCurve(const std::string& name, const MaterialResult& result) {
  Curve curve{name, {}};
  const auto n = static_cast<double>(result.taus.size());
  for (std::size_t i = 0; i < result.taus.front().size(); ++i) {
    auto& [tau, dropped] = curve.points.emplace_back(result.taus.front()[i].tau, 0);
    for (std::size_t set = 0; set < result.taus.size(); ++set) {
      const double all = std::max(1, result.curves[set][0][0].vectors);
      dropped += (1 - result.taus[set][i].vectors / all) / n;
    }
  }
  return curve;
}

/// Vectors left by tau as text, for what a plot does not tell near 0.
Table tauTable(const std::vector<Curve>& curves) {
  Table table{"figure_7_2_tau",
              "Figure 7.2, right: per cent of the vectors dropped by tau, normalization off",
              {{"tau"}}};
  for (const auto& point : curves.front().points) {
    char tau[32];
    std::snprintf(tau, sizeof(tau), "%g", point.first);
    table.rows[0].emplace_back(tau);
  }
  for (const Curve& curve : curves) {
    std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{curve.name});
    for (const auto& point : curve.points) row.push_back(fixed(100 * point.second, 1));
  }
  return table;
}

}  // namespace

Findings materialFindings(const std::vector<MaterialResult>& results) {
  Findings findings;
  std::vector<Curve> left, right;  // of figure 7.2
  for (const ThesisMaterialTable& table : materialTables()) {
    const std::string number = table.number;
    findings.tables.push_back(materialTable(results, table));
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const MaterialResult& result = *chosen(results, table, i);
      curves.push_back(rateCurve(label(result, number), result));
      const bool in_figure_7_2 = (number == "7.3" || number == "7.4") && (i == 0 || i == 2);
      if (!in_figure_7_2) continue;
      const std::string name = std::string(table.feature) + " " + result.classifier.kernel.type;
      left.push_back(rateCurve(name, result));
      right.push_back(tauCurve(name, result));
    }
    if (number == "7.1" || number == "7.2") {
      findings.figures.push_back({number == "7.1" ? "figure_7_3" : "figure_7_4",
                                  sharesPlot("vectors left", "rate", curves)});
    }
  }
  findings.tables.push_back(tauTable(right));
  findings.figures.push_back({"figure_7_2_left", sharesPlot("vectors left", "rate", left)});
  findings.figures.push_back({"figure_7_2_right", sharesPlot("tau", "vectors dropped", right)});
  return findings;
}

}  // namespace place_recognition
