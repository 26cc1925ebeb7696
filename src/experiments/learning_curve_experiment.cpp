#include "experiments/experiments.h"

#include <algorithm>
#include <memory>
#include <set>

#include "base/options.h"
#include "base/parallel.h"
#include "base/text.h"
#include "experiments/place_training.h"
#include "experiments/spread.h"
#include "experiments/training_subsets.h"
#include "experiments/viewpoint_page.h"

namespace place_recognition {
namespace {

constexpr int kCounts[] = {1, 2, 4, 8, 16, 32, 64, 128};
constexpr std::size_t kSalient = 5;  ///< viewpoints shown per training set
constexpr const char* kColumns[] = {"spread", "neighbours"};

/// `train` without `dropped`.
std::vector<int> without(const std::vector<int>& train, const std::vector<int>& dropped) {
  const std::set<int> gone(dropped.begin(), dropped.end());
  std::vector<int> left;
  std::copy_if(train.begin(), train.end(), std::back_inserter(left),
               [&gone](int i) { return gone.count(i) == 0; });
  return left;
}

/// Rates on the test sets of machines trained on each of `subsets`.
std::vector<double> ratesOf(const std::vector<std::vector<int>>& subsets,
                            const Eigen::MatrixXd& gram, const SetSamples& samples,
                            const std::vector<int>& test, const SvmOptions& svm, unsigned threads,
                            const Progress& progress) {
  std::vector<double> rates(subsets.size());
  parallelFor(subsets.size(), threads, [&](std::size_t i, unsigned thread) {
    if (thread == 0) report(progress, "Training", static_cast<double>(i) / subsets.size());
    rates[i] = rateOf(gram, samples, {subsets[i], test}, svm);
  });
  return rates;
}

/// The viewpoints whose omission costs most, in descending order.
std::vector<Json> salient(const Json& result) {
  std::vector<Json> viewpoints = result.at("viewpoints");
  std::stable_sort(viewpoints.begin(), viewpoints.end(), [](const Json& a, const Json& b) {
    return a.at("rate").get<double>() < b.at("rate").get<double>();
  });
  viewpoints.resize(std::min(viewpoints.size(), kSalient));
  return viewpoints;
}

class LearningCurveExperiment : public Experiment {
 public:
  LearningCurveExperiment(std::vector<ImageSet> sets, unsigned threads)
      : sets_(std::move(sets)), threads_(threads) {}

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const ImageSet& set : sets_) {
      cells.push_back({{"learning_curve", writeOptions(trainingOptions(PlaceFeatures::kGlobal))},
                       {"training_set", set.name}});
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    const PlaceSamples places(sets_, PlaceFeatures::kGlobal, threads_, progress);
    warn(places.warnings());
    const SetSamples& samples = places.samples();
    const SvmOptions svm = trainingOptions(PlaceFeatures::kGlobal).svm;
    const Eigen::MatrixXd measures = places.measures(progress);
    std::size_t next = 0;  // cells are in the order of cells()
    for (std::size_t set = 0; set < sets_.size() && next < cells.size(); ++set) {
      if (cells[next].at("training_set") != sets_[set].name) continue;
      const Fold split = samples.split(static_cast<int>(set));
      const double gamma = places.train(split, progress).gamma;
      const Eigen::MatrixXd gram = places.gramMatrix(measures, gamma);

      std::vector<std::vector<int>> subsets = {split.train};
      for (const SubsetKind kind : {SubsetKind::kSpread, SubsetKind::kNeighbours}) {
        for (const int count : kCounts) {
          subsets.push_back(subsetOf(split.train, samples, count, kind));
        }
      }
      const std::vector<Viewpoint> viewpoints = viewpointsOf(split.train, samples);
      for (const Viewpoint& view : viewpoints) {
        subsets.push_back(without(split.train, view.samples));
      }
      const std::vector<double> rates =
          ratesOf(subsets, gram, samples, split.test, svm, threads_, progress);

      Json result = {{"gamma", gamma}, {"all", rates[0]}, {"viewpoints", Json::array()}};
      std::size_t i = 1;
      for (const char* column : kColumns) {
        for ([[maybe_unused]] const int count : kCounts) result[column].push_back(rates[i++]);
      }
      for (const Viewpoint& view : viewpoints) {
        result["viewpoints"].push_back(
            {{"place", places.places()[static_cast<std::size_t>(view.place)]},
             {"number", view.number},
             {"rate", rates[i++]}});
      }
      finished(cells[next++], result);
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    Table curve{
        "learning_curve",
        "Rate on the other sets by images per room that are learned, spread over the room or "
        "neighbours; mean +- standard deviation over the training sets",
        {{"images per room", "spread, %", "neighbours, %"}}};
    const auto cell = [&](const auto& rateIn) {
      std::vector<double> rates;
      for (const Json& result : results) rates.push_back(100 * rateIn(result));
      return plusMinus(spreadOf(rates), 1);
    };
    for (std::size_t i = 0; i < std::size(kCounts); ++i) {
      curve.rows.push_back({std::to_string(kCounts[i])});
      for (const char* column : kColumns) {
        curve.rows.back().push_back(
            cell([&](const Json& r) { return r.at(column).at(i).get<double>(); }));
      }
    }
    curve.rows.push_back(
        {"all", cell([](const Json& r) { return r.at("all").get<double>(); }), ""});

    Table viewpoints{
        "viewpoints",
        "Viewpoints (twelve successive images of a room) without which the rate on the "
        "other sets falls most",
        {{"trained on", "room", "viewpoint", "rate, %", "change, points"}}};
    std::vector<ShownViewpoint> shown;
    for (std::size_t set = 0; set < results.size(); ++set) {
      const double all = results[set].at("all");
      for (const Json& view : salient(results[set])) {
        const double rate = view.at("rate");
        viewpoints.rows.push_back({sets_[set].name, view.at("place").get<std::string>(),
                                   view.at("number").dump(), fixed(100 * rate, 1),
                                   fixed(100 * (rate - all), 1)});
        shown.push_back({sets_[set].name, view.at("place"), view.at("number"), all, rate,
                         imagesOf(sets_[set], view.at("place"), view.at("number"))});
      }
    }
    return {{curve, viewpoints}, {}, {{"viewpoints", viewpointPage(shown)}}};
  }

 private:
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Experiment> learningCurveExperiment(std::vector<ImageSet> sets, unsigned threads) {
  return std::make_unique<LearningCurveExperiment>(std::move(sets), threads);
}

}  // namespace place_recognition
