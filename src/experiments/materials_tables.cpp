#include "experiments/materials_tables.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "experiments/material_grid.h"
#include "experiments/spread.h"
#include "experiments/thesis_materials.h"
#include "report/fraction_plot.h"

namespace place_recognition {
namespace {

constexpr double kLeastRate = 0.3;
constexpr const char* kKernelTypes[] = {"chi-squared", "gaussian", "polynomial p=0",
                                        "polynomial p=1"};

/// A number for each split.
template <typename NumberOf>
std::vector<double> each(const MaterialResult& result, const NumberOf& number_of) {
  std::vector<double> numbers;
  for (const MaterialOutcome& outcome : result.outcomes) numbers.push_back(number_of(outcome));
  return numbers;
}

std::vector<double> rates(const MaterialResult& result) {
  return each(result, [](const MaterialOutcome& outcome) { return 100 * outcome.rate; });
}

/// Percentage of the vectors dropped at a fraction of the rate.
std::vector<double> dropped(const MaterialResult& result, std::size_t fraction) {
  return each(result, [fraction](const MaterialOutcome& outcome) {
    return 100 - 100.0 * outcome.fewest[fraction] / std::max(1, outcome.vectors);
  });
}

double meanValidation(const MaterialResult& result) {
  return spreadOf(each(result, [](const auto& outcome) { return outcome.validation; })).mean;
}

bool isRejected(const MaterialResult& result) {
  return spreadOf(rates(result)).mean < 100 * kLeastRate;
}

/// Rate and vectors before reduction, and the vectors dropped at each fraction of the rate.
std::vector<std::string> measured(const MaterialResult& result) {
  std::vector<std::string> cells = {
      plusMinus(spreadOf(rates(result)), 2),
      plusMinus(spreadOf(each(result, [](const auto& outcome) { return outcome.vectors; })), 0)};
  for (std::size_t fraction = 0; fraction < std::size(kMaterialFractions); ++fraction) {
    cells.push_back(plusMinus(spreadOf(dropped(result, fraction)), 2));
  }
  return cells;
}

std::vector<std::string> printed(const ThesisMaterial& thesis) {
  std::vector<std::string> cells = {"| " + thesis.kernel,
                                    plusMinus({thesis.rate, thesis.rate_deviation}, 2),
                                    std::to_string(thesis.vectors)};
  for (const double reduction : thesis.reduction) cells.push_back(fixed(reduction, 2));
  return cells;
}

bool isNear(double a, double b) { return std::abs(a - b) < 1e-6 * b; }

/// One of kKernelTypes.
std::string typeOf(const KernelOptions& kernel) {
  return kernel.type + (kernel.type != "polynomial" ? "" : kernel.p == 0 ? " p=0" : " p=1");
}

/// Whether a classifier is of the kind in row `row` of a table.
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
  return classifier.svm.c == 100 && typeOf(classifier.kernel) == kKernelTypes[row];
}

/// The `eligible` classifier with the best validation that is not rejected; null if there is none.
template <typename IsEligible>
const MaterialResult* best(const std::vector<MaterialResult>& results, int samples,
                           const IsEligible& is_eligible) {
  const MaterialResult* best = nullptr;
  for (const MaterialResult& result : results) {
    if (result.classifier.samples != samples || !is_eligible(result.classifier)) continue;
    if (isRejected(result)) continue;
    if (!best || meanValidation(result) > meanValidation(*best)) best = &result;
  }
  return best;
}

std::string label(const MaterialResult& result, const std::string& table) {
  if (table != "7.2") return describe(result.classifier.kernel);
  return "C=" + fixed(result.classifier.svm.c, 0);
}

/// The classifiers of a table's rows; null: all rejected.
std::vector<const MaterialResult*> chosen(const std::vector<MaterialResult>& results,
                                          const ThesisMaterialTable& table, int samples) {
  std::vector<const MaterialResult*> rows;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    rows.push_back(best(results, samples, [&](const MaterialClassifier& classifier) {
      return belongs(classifier, table, row);
    }));
  }
  return rows;
}

std::vector<std::string> head(std::vector<std::string> columns) {
  for (const int fraction : kMaterialFractions)
    columns.push_back("at " + std::to_string(fraction) + " %");
  return columns;
}

Table materialTable(const std::vector<const MaterialResult*>& chosen,
                    const ThesisMaterialTable& thesis) {
  Table table;
  const std::string number = thesis.number;
  table.name = "table_7_" + number.substr(2);
  table.title =
      "Table " + number + ": " + thesis.feature + ", " + thesis.multiclass +
      ". Rate, vectors, and per cent of them dropped while keeping a fraction of the rate; "
      "mean +- standard deviation over the splits; right, the thesis on KTH-TIPS2";
  const std::vector<std::string> right = head({"| classifier", "rate, %", "vectors"});
  table.rows.push_back(head({"classifier", "rate, %", "vectors"}));
  table.rows[0].insert(table.rows[0].end(), right.begin(), right.end());
  for (std::size_t i = 0; i < thesis.rows.size(); ++i) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row.push_back(chosen[i] ? label(*chosen[i], number) : "rejected: below 30 %");
    const std::vector<std::string> cells =
        chosen[i] ? measured(*chosen[i]) : std::vector<std::string>(right.size() - 1);
    row.insert(row.end(), cells.begin(), cells.end());
    const std::vector<std::string> beside = printed(thesis.rows[i]);
    row.insert(row.end(), beside.begin(), beside.end());
  }
  return table;
}

/// Rate against vectors left, mean over the splits, normalized.
Curve rateCurve(const std::string& name, const MaterialResult& result) {
  std::vector<ReductionCurve> curves;
  for (const MaterialOutcome& outcome : result.outcomes) curves.push_back(outcome.curve);
  return {name, meanCurve(curves)};
}

/// Fraction of vectors dropped against tau, mean over the splits.
Curve tauCurve(const std::string& name, const MaterialResult& result) {
  Curve curve{name, {}};
  const auto n = static_cast<double>(result.outcomes.size());
  for (std::size_t i = 0; i < result.outcomes.front().taus.size(); ++i) {
    auto& [tau, fraction] = curve.points.emplace_back(result.outcomes.front().taus[i].tau, 0);
    for (const MaterialOutcome& outcome : result.outcomes) {
      fraction += (1 - outcome.taus[i].vectors / std::max(1.0, 1.0 * outcome.vectors)) / n;
    }
  }
  return curve;
}

/// Vectors left by tau as text, because a plot does not show small values.
Table tauTable(const std::vector<Curve>& curves) {
  Table table{"figure_7_2_tau",
              "Figure 7.2, right: per cent of the vectors dropped by tau, normalization off",
              {{"tau"}}};
  if (curves.empty()) return table;
  for (const auto& point : curves.front().points) {
    table.rows[0].push_back(significant(point.first));
  }
  for (const Curve& curve : curves) {
    std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{curve.name});
    for (const auto& point : curve.points) row.push_back(fixed(100 * point.second, 1));
  }
  return table;
}

std::set<int> sampleCounts(const std::vector<MaterialResult>& results) {
  std::set<int> counts;
  for (const MaterialResult& result : results) counts.insert(result.classifier.samples);
  return counts;
}

/// The effect of fewer training samples.
Table samplesTable(const std::vector<MaterialResult>& results) {
  Table table{"table_7_samples",
              "By the number of samples of each material that are trained on, C = 100: kernel "
              "chosen, rate, vectors, and per cent of them dropped while keeping all of the rate",
              {{"feature", "machines", "kernel"}}};
  for (const int samples : sampleCounts(results)) {
    for (const char* column : {"kernel", "rate, %", "vectors", "dropped"}) {
      table.rows[0].push_back("| " + std::to_string(samples) + ": " + column);
    }
  }
  for (const char* feature : kMaterialFeatures) {
    for (const char* multiclass : {"one-against-one", "one-against-all"}) {
      for (const char* type : kKernelTypes) {
        std::vector<std::string> row = {feature, multiclass, type};
        for (const int samples : sampleCounts(results)) {
          const MaterialResult* const result =
              best(results, samples, [&](const MaterialClassifier& classifier) {
                return classifier.feature == feature && classifier.svm.multiclass == multiclass &&
                       classifier.svm.c == 100 && typeOf(classifier.kernel) == type;
              });
          const std::vector<std::string> cells =
              result ? measured(*result) : std::vector<std::string>(3);
          row.push_back(result ? describe(result->classifier.kernel) : "rejected: below 30 %");
          row.insert(row.end(), cells.begin(), cells.begin() + 3);
        }
        table.rows.push_back(row);
      }
    }
  }
  return table;
}

/// All classifiers by feature and number of training samples.
Table gridTable(const std::vector<MaterialResult>& results) {
  Table table{"table_7_grid",
              "All classifiers: how many, how many of them are rejected (rate below 30 %), best "
              "rate of the others, and per cent of their vectors dropped on average while keeping "
              "a fraction of the rate",
              {head({"feature", "samples", "classifiers", "rejected", "best rate, %"})}};
  for (const char* feature : kMaterialFeatures) {
    for (const int samples : sampleCounts(results)) {
      int count = 0, rejected = 0;
      double best_rate = 0;
      std::vector<std::vector<double>> fractions(std::size(kMaterialFractions));
      for (const MaterialResult& result : results) {
        if (result.classifier.feature != feature || result.classifier.samples != samples) continue;
        ++count;
        if (isRejected(result)) {
          ++rejected;
          continue;
        }
        best_rate = std::max(best_rate, spreadOf(rates(result)).mean);
        for (std::size_t i = 0; i < fractions.size(); ++i) {
          fractions[i].push_back(spreadOf(dropped(result, i)).mean);
        }
      }
      std::vector<std::string> row = {feature, std::to_string(samples), std::to_string(count),
                                      std::to_string(rejected), fixed(best_rate, 2)};
      for (const std::vector<double>& fraction : fractions)
        row.push_back(plusMinus(spreadOf(fraction), 2));
      table.rows.push_back(row);
    }
  }
  return table;
}

}  // namespace

Findings materialFindings(const std::vector<MaterialResult>& results) {
  Findings findings;
  std::vector<Curve> left, right;  // of figure 7.2
  const int samples = *sampleCounts(results).rbegin();
  for (const ThesisMaterialTable& table : materialTables()) {
    const std::string number = table.number;
    const std::vector<const MaterialResult*> rows = chosen(results, table, samples);
    findings.tables.push_back(materialTable(rows, table));
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i]) continue;
      curves.push_back(rateCurve(label(*rows[i], number), *rows[i]));
      const bool in_figure_7_2 = (number == "7.3" || number == "7.4") && (i == 0 || i == 2);
      if (!in_figure_7_2) continue;
      const std::string name = std::string(table.feature) + " " + kKernelTypes[i];
      left.push_back(rateCurve(name, *rows[i]));
      right.push_back(tauCurve(name, *rows[i]));
    }
    if (number == "7.1" || number == "7.2") {
      findings.figures.push_back({number == "7.1" ? "figure_7_3" : "figure_7_4",
                                  fractionsPlot("vectors left", "rate", curves)});
    }
  }
  findings.tables.push_back(tauTable(right));
  findings.tables.push_back(samplesTable(results));
  findings.tables.push_back(gridTable(results));
  findings.figures.push_back({"figure_7_2_left", fractionsPlot("vectors left", "rate", left)});
  findings.figures.push_back({"figure_7_2_right", fractionsPlot("tau", "vectors dropped", right)});
  return findings;
}

}  // namespace place_recognition
