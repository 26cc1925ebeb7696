#include "experiments/experiments.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "base/options.h"
#include "base/parallel.h"
#include "experiments/reduction_curve.h"
#include "experiments/spread.h"
#include "experiments/thesis_places.h"
#include "learning/reduction.h"
#include "report/fraction_plot.h"

namespace place_recognition {
namespace {

/// A way to reduce; the thesis' own occurs twice, because its tables use the better of both.
struct Way {
  std::size_t method;  ///< index into kReductionMethods
  bool normalize;
};
constexpr Way kWays[] = {{0, true}, {0, false}, {1, true}, {2, true}};

constexpr PlaceFeatures kFeatures[] = {PlaceFeatures::kLocal, PlaceFeatures::kGlobal};

/// Curves of one kind of features: [method][training set]; there may be several per method.
using Curves = std::vector<std::vector<std::vector<ReductionCurve>>>;

/// Over the training sets: the rate, the number of vectors that retain a fraction of it, and the
/// fraction of all vectors that this drops.
struct Kept {
  std::vector<double> rates, vectors, dropped;
};

Kept keptAt(const std::vector<std::vector<ReductionCurve>>& by_set, double fraction) {
  Kept kept;
  for (const std::vector<ReductionCurve>& curves : by_set) {
    const CurvePoint& all = curves.front().front();
    const int fewest = fewestVectors(curves, fraction);
    kept.rates.push_back(100 * fraction * all.rate);
    kept.vectors.push_back(fewest);
    kept.dropped.push_back(all.vectors > 0 ? 100.0 * (all.vectors - fewest) / all.vectors : 0);
  }
  return kept;
}

Table reductionTable(PlaceFeatures features, const Curves& curves) {
  const bool local = features == PlaceFeatures::kLocal;
  const std::vector<ThesisReduction>& thesis = local ? table83() : table87();
  Table table;
  table.name = local ? "table_8_3" : "table_8_7";
  table.title = std::string(local ? "Table 8.3: local" : "Table 8.7: global") +
                " features. Rate kept against vectors dropped; mean +- standard deviation over the "
                "training sets; qr is the thesis' method, whose own figures stand right";
  table.rows = {{"rate kept, %", "rate, %", "qr: dropped, %", "vectors", "shared-qr: dropped, %",
                 "vectors", "shared-greedy: dropped, %", "vectors", "| rate, %", "dropped, %",
                 "vectors"}};
  for (const ThesisReduction& row : thesis) {
    const bool original = row.percent == 0;
    std::vector<std::string> cells = {original ? "original" : std::to_string(row.percent)};
    for (std::size_t m = 0; m < curves.size(); ++m) {
      const Kept kept = keptAt(curves[m], original ? 1 : row.percent / 100.0);
      if (m == 0) cells.push_back(plusMinus(spreadOf(kept.rates), 2));
      if (original) {
        std::vector<double> all;
        for (const auto& by_set : curves[m]) all.push_back(by_set.front().front().vectors);
        cells.insert(cells.end(), {"", plusMinus(spreadOf(all), 0)});
      } else {
        cells.push_back(plusMinus(spreadOf(kept.dropped), 2));
        cells.push_back(plusMinus(spreadOf(kept.vectors), 0));
      }
    }
    cells.push_back("| " + plusMinus({row.rate, row.rate_deviation}, 2));
    cells.push_back(original ? "" : plusMinus({row.reduction, row.reduction_deviation}, 2));
    cells.push_back(std::to_string(row.vectors) + " +- " + std::to_string(row.vectors_deviation));
    table.rows.push_back(cells);
  }
  return table;
}

/// The effect of tau on vectors and rate, by the thesis' method with and without normalization.
Table tauTable(PlaceFeatures features, const std::vector<std::vector<ReductionCurve>>& by_set) {
  Table table;
  table.name = features == PlaceFeatures::kLocal ? "table_8_3_tau" : "table_8_7_tau";
  table.title =
      std::string(name(features)) +
      " features by tau, method qr, normalized columns and as they are. At 1e-9 only what "
      "depends on the rest is dropped; empty where a rate was below 70 % before";
  table.rows = {{"tau", "normalized: dropped, %", "rate, %", "not: dropped, %", "rate, %"}};
  for (const double tau : {kExactTau, 1e-6, 1e-4, 1e-3, 0.003, 0.01, 0.03, 0.1, 0.3}) {
    std::vector<std::string>& cells =
        table.rows.emplace_back(std::vector<std::string>{significant(tau)});
    for (const std::size_t way : {0, 1}) {
      std::vector<double> dropped, rates;
      for (const std::vector<ReductionCurve>& curves : by_set) {
        const CurvePoint* const point = pointAt(curves[way], tau);
        if (!point) continue;
        dropped.push_back(100 - 100.0 * point->vectors / std::max(1, curves[way][0].vectors));
        rates.push_back(100 * point->rate);
      }
      const bool all = rates.size() == by_set.size();
      cells.push_back(all ? plusMinus(spreadOf(dropped), 2) : "");
      cells.push_back(all ? plusMinus(spreadOf(rates), 2) : "");
    }
  }
  return table;
}

/// Rate, averaged over the training sets, against vectors left, for the first curve of each method.
Figure reductionFigure(PlaceFeatures features, const Curves& curves) {
  std::vector<Curve> lines;
  for (std::size_t m = 0; m < curves.size(); ++m) {
    std::vector<ReductionCurve> firsts;
    for (const auto& by_set : curves[m]) firsts.push_back(by_set.front());
    lines.push_back({kReductionMethods[m], meanCurve(firsts)});
  }
  return {std::string("reduction_") + name(features), fractionsPlot("vectors left", "rate", lines)};
}

class ReductionExperiment : public Experiment {
 public:
  ReductionExperiment(std::vector<ImageSet> sets, unsigned threads)
      : sets_(std::move(sets)), threads_(threads) {}

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const PlaceFeatures features : kFeatures) {
      for (const ImageSet& set : sets_) {
        for (const Way& way : kWays) {
          cells.push_back({{"reduction", writeOptions(trainingOptions(features))},
                           {"features", name(features)},
                           {"training_set", set.name},
                           {"method", kReductionMethods[way.method]},
                           {"normalize", way.normalize}});
        }
      }
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    for (const PlaceFeatures features : kFeatures) {
      std::unique_ptr<PlaceSamples> samples;  // only if needed
      for (std::size_t set = 0; set < sets_.size(); ++set) {
        std::vector<const Json*> wanted;
        for (const Json& cell : cells) {
          const bool here =
              cell.at("features") == name(features) && cell.at("training_set") == sets_[set].name;
          if (here) wanted.push_back(&cell);
        }
        if (wanted.empty()) continue;
        if (!samples) {
          samples = std::make_unique<PlaceSamples>(sets_, features, threads_, progress);
          warn(samples->warnings());
        }
        const PlaceTraining training =
            samples->train(samples->samples().split(static_cast<int>(set)), progress);
        const RateOf rate = [&](const BinarySvms& machines) {
          return training.rate(machines, samples->samples());
        };
        std::vector<ReductionCurve> curves(wanted.size());
        parallelFor(wanted.size(), threads_, [&](std::size_t i, unsigned thread) {
          if (thread == 0) report(progress, "Reducing", static_cast<double>(i) / wanted.size());
          const Json& cell = *wanted[i];
          curves[i] = reductionCurve(training.machines, training.training_values, cell.at("method"),
                                     cell.at("normalize"), rate);
        });
        for (std::size_t i = 0; i < wanted.size(); ++i) {
          finished(*wanted[i], {{"curve", toJson(curves[i])}, {"gamma", training.gamma}});
        }
      }
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    Findings findings;
    std::size_t next = 0;
    for (const PlaceFeatures features : kFeatures) {
      Curves curves(std::size(kReductionMethods),
                    std::vector<std::vector<ReductionCurve>>(sets_.size()));
      for (std::size_t set = 0; set < sets_.size(); ++set) {
        for (const Way& way : kWays) {
          curves[way.method][set].push_back(curveFromJson(results[next++].at("curve")));
        }
      }
      findings.tables.push_back(reductionTable(features, curves));
      findings.tables.push_back(tauTable(features, curves[0]));
      findings.figures.push_back(reductionFigure(features, curves));
    }
    return findings;
  }

 private:
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Experiment> reductionExperiment(std::vector<ImageSet> sets, unsigned threads) {
  return std::make_unique<ReductionExperiment>(std::move(sets), threads);
}

}  // namespace place_recognition
