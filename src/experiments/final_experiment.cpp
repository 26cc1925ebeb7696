#include "experiments/experiments.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/options.h"
#include "base/text.h"
#include "experiments/thesis_places.h"

namespace place_recognition {
namespace {

/// Empty if the thesis has no figure.
std::string thesisRate(double rate) { return rate < 0 ? "" : fixed(rate, 2); }

/// The rate of one test set after a training, in per cent; empty if there is none.
std::string rateIn(const Json& result, const std::string& place, const std::string& set) {
  for (const Json& count : result.at("counts")) {
    if (count.at("place") != place || count.at("set") != set) continue;
    return fixed(100.0 * count.at("right").get<int>() / count.at("total").get<int>(), 2);
  }
  return "";
}

using TableRow = std::vector<std::string>;

/// One number of each result, times `factor`.
TableRow numbers(const char* label, const std::vector<Json>& results, const char* key,
                 double factor, int decimals) {
  TableRow row = {label, ""};
  for (const Json& result : results) {
    row.push_back(fixed(factor * result.at(key).get<double>(), decimals));
  }
  return row;
}

/// Adds the thesis' figures for its three training sets; `figure`: by set.
template <typename Figure>
void addThesis(const Figure& figure, TableRow& row) {
  for (int i = 0; i < 3; ++i) row.push_back((i == 0 ? "| " : "") + figure(i));
}

class FinalExperiment : public Experiment {
 public:
  FinalExperiment(PlaceFeatures features, std::vector<ImageSet> sets, unsigned threads)
      : features_(features), sets_(std::move(sets)), threads_(threads) {}

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const ImageSet& set : sets_) {
      cells.push_back(
          {{"final", writeOptions(trainingOptions(features_))}, {"training_set", set.name}});
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    const PlaceSamples samples(sets_, features_, threads_, progress);
    warn(samples.warnings());
    for (const Json& cell : cells) {
      const auto set = std::find_if(sets_.begin(), sets_.end(), [&](const ImageSet& candidate) {
        return candidate.name == cell.at("training_set");
      });
      const PlaceTraining training =
          samples.train(samples.samples().split(static_cast<int>(set - sets_.begin())), progress);
      const auto counts = testCounts(samples.samples(), training.test,
                                     answersOf(training.machines, training.test_values));
      Json list = Json::array();
      for (const TestCount& count : counts) {
        list.push_back({{"place", samples.places()[static_cast<std::size_t>(count.place)]},
                        {"set", sets_[static_cast<std::size_t>(count.set)].name},
                        {"right", count.right},
                        {"total", count.total}});
      }
      finished(cell, {{"counts", list},
                      {"rate", meanRate(counts)},
                      {"gamma", training.gamma},
                      {"support_vectors", training.machines.weights.rows()}});
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    const bool local = features_ == PlaceFeatures::kLocal;
    const ThesisFinal& thesis = local ? table82() : table86();
    Table table;
    table.name = local ? "table_8_2" : "table_8_6";
    table.title = std::string(local ? "Table 8.2: local" : "Table 8.6: global") +
                  " descriptors. Rates in per cent by training set (columns) and test set; right, "
                  "the thesis, for rooms that go by its names";
    TableRow& head = table.rows.emplace_back(TableRow{"room", "tested on"});
    for (const ImageSet& set : sets_) head.push_back(set.name);
    for (const char* column : {"| cloudy", "night", "sunny"}) head.emplace_back(column);
    table.rows.push_back(numbers("gamma", results, "gamma", 1, 3));
    addThesis([&](int i) { return fixed(thesis.gamma[i], 3); }, table.rows.back());
    table.rows.push_back(numbers("support vectors", results, "support_vectors", 1, 0));
    for (const std::string& place : places()) {
      for (const ImageSet& set : sets_) {
        TableRow& row = table.rows.emplace_back(TableRow{place, set.name});
        for (const Json& result : results) row.push_back(rateIn(result, place, set.name));
        addThesis([&](int i) { return thesisRate(thesis.rate(place, set.name, i)); }, row);
      }
    }
    table.rows.push_back(numbers("average", results, "rate", 100, 2));
    addThesis([&](int i) { return fixed(thesis.average[i], 2); }, table.rows.back());
    return {{splits(), table}, {}};
  }

 private:
  /// All places, in ascending order.
  std::set<std::string> places() const {
    std::set<std::string> places;
    for (const ImageSet& set : sets_) {
      for (const LabelledImage& image : set.images) places.insert(image.place);
    }
    return places;
  }

  Table splits() const {
    Table table{"table_8_1",
                "Table 8.1: images by room and set; each set is trained on in turn and tested on "
                "the rooms of the others",
                {{"room"}}};
    std::map<std::string, std::vector<int>> counts;
    std::vector<std::string> total = {"all"};
    for (std::size_t set = 0; set < sets_.size(); ++set) {
      table.rows[0].push_back(sets_[set].name);
      total.push_back(std::to_string(sets_[set].images.size()));
      for (const LabelledImage& image : sets_[set].images) {
        std::vector<int>& room = counts[image.place];
        room.resize(sets_.size());
        ++room[set];
      }
    }
    for (const auto& [room, by_set] : counts) {
      std::vector<std::string>& row = table.rows.emplace_back(1, room);
      for (const int count : by_set) row.push_back(std::to_string(count));
    }
    table.rows.push_back(total);
    return table;
  }

  PlaceFeatures features_;
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Experiment> finalExperiment(PlaceFeatures features, std::vector<ImageSet> sets,
                                            unsigned threads) {
  return std::make_unique<FinalExperiment>(features, std::move(sets), threads);
}

}  // namespace place_recognition
