#include "experiments/experiments.h"

#include <map>
#include <memory>
#include <utility>

#include "base/options.h"
#include "base/text.h"
#include "experiments/spread.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr PlaceFeatures kFeatures[] = {PlaceFeatures::kLocal, PlaceFeatures::kGlobal};

/// Rates of one kind of features: by place, and their mean under an empty name.
Table categoryTable(PlaceFeatures features, const std::vector<ImageSet>& buildings,
                    const std::vector<const Json*>& results) {
  Table table;
  table.name = std::string("categories_") + name(features);
  table.title = std::string(name(features)) +
                " features: rate, %, of each kind of place in a building, trained on all others";
  std::vector<std::string>& head = table.rows.emplace_back(std::vector<std::string>{"place"});
  std::map<std::string, std::vector<std::string>> rows;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    head.push_back(buildings[b].name);
    for (const Json& count : results[b]->at("counts")) {
      std::vector<std::string>& row = rows[count.at("place")];
      row.resize(b);
      row.push_back(fixed(100 * count.at("rate").get<double>(), 1));
    }
  }
  for (auto& [place, cells] : rows) {
    cells.resize(buildings.size());
    cells.insert(cells.begin(), place);
    table.rows.push_back(cells);
  }
  std::vector<std::string>& mean = table.rows.emplace_back(std::vector<std::string>{"mean"});
  std::vector<double> rates;
  for (const Json* result : results) {
    rates.push_back(100 * result->at("rate").get<double>());
    mean.push_back(fixed(rates.back(), 1));
  }
  table.title += "; mean " + plusMinus(spreadOf(rates), 1);
  return table;
}

class CategoriesExperiment : public Experiment {
 public:
  CategoriesExperiment(std::vector<ImageSet> buildings, unsigned threads)
      : buildings_(std::move(buildings)), threads_(threads) {
    if (buildings_.size() >= 3) return;
    throw Error(
        "There are fewer than three buildings; give a folder of BUILDING/CONDITION/ROOM/IMAGE with "
        "three buildings or more.");
  }

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const PlaceFeatures features : kFeatures) {
      for (const ImageSet& building : buildings_) {
        cells.push_back({{"categories", writeOptions(trainingOptions(features))},
                         {"features", name(features)},
                         {"tested", building.name}});
      }
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    std::size_t next = 0;  // cells are in the order of cells()
    for (const PlaceFeatures features : kFeatures) {
      std::unique_ptr<PlaceSamples> samples;  // only if needed
      for (std::size_t b = 0; b < buildings_.size() && next < cells.size(); ++b) {
        const Json& cell = cells[next];
        if (cell.at("features") != name(features)) break;
        if (cell.at("tested") != buildings_[b].name) continue;
        if (!samples) {
          samples = std::make_unique<PlaceSamples>(buildings_, features, threads_, progress);
          warn(samples->warnings());
        }
        Fold split = samples->samples().split(static_cast<int>(b));
        std::swap(split.train, split.test);
        const PlaceTraining training = samples->train(split, progress);
        const auto counts = testCounts(samples->samples(), training.test,
                                       answersOf(training.machines, training.test_values));
        Json result = {
            {"gamma", training.gamma}, {"rate", meanRate(counts)}, {"counts", Json::array()}};
        for (const TestCount& count : counts) {
          result["counts"].push_back(
              {{"place", samples->places()[static_cast<std::size_t>(count.place)]},
               {"rate", static_cast<double>(count.right) / count.total},
               {"total", count.total}});
        }
        finished(cell, result);
        ++next;
      }
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    Findings findings;
    std::size_t next = 0;
    for (const PlaceFeatures features : kFeatures) {
      std::vector<const Json*> of_features;
      for (std::size_t b = 0; b < buildings_.size(); ++b) of_features.push_back(&results[next++]);
      findings.tables.push_back(categoryTable(features, buildings_, of_features));
    }
    return findings;
  }

 private:
  std::vector<ImageSet> buildings_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Experiment> categoriesExperiment(std::vector<ImageSet> buildings,
                                                 unsigned threads) {
  return std::make_unique<CategoriesExperiment>(std::move(buildings), threads);
}

}  // namespace place_recognition
