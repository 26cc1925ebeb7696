#include "experiments/experiments.h"

#include <algorithm>
#include <map>

#include "base/options.h"
#include "base/parallel.h"
#include "experiments/material_features.h"
#include "experiments/material_grid.h"
#include "experiments/materials_tables.h"
#include "experiments/test_sets.h"
#include "experiments/thesis_materials.h"
#include "learning/gram.h"
#include "learning/reduction.h"
#include "learning/selection.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr double kTaus[] = {1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3};

bool isTrainedOn(const TrainingSamples& split, int set) {
  return std::find(split.begin(), split.end(), set) != split.end();
}

Fold foldOf(const SetSamples& samples, const TrainingSamples& split) {
  Fold fold;
  for (std::size_t i = 0; i < samples.sets.size(); ++i) {
    (isTrainedOn(split, samples.sets[i]) ? fold.train : fold.test).push_back(static_cast<int>(i));
  }
  return fold;
}

/// Mean rate on held-out parts of the training images: on each sample or, if there is only one, on
/// three blocks of neighbours of each material.
double validate(const Eigen::MatrixXd& gram, const SetSamples& samples,
                const std::vector<int>& train, const SvmOptions& svm) {
  constexpr int kBlocks = 3;
  std::map<int, std::vector<int>> of_set, of_place;
  for (const int i : train) {
    of_set[samples.sets[static_cast<std::size_t>(i)]].push_back(i);
    of_place[samples.places[static_cast<std::size_t>(i)]].push_back(i);
  }
  std::map<int, std::vector<int>> parts = of_set;
  if (of_set.size() == 1) {
    parts.clear();
    for (const auto& [place, images] : of_place) {
      for (std::size_t k = 0; k < images.size(); ++k) {
        parts[static_cast<int>(kBlocks * k / images.size())].push_back(images[k]);
      }
    }
  }
  double sum = 0;
  for (const auto& [part, tested] : parts) {
    Fold fold{{}, tested};
    for (const int i : train) {
      if (std::find(tested.begin(), tested.end(), i) == tested.end()) fold.train.push_back(i);
    }
    sum += rateOf(gram, samples, fold, svm);
  }
  return sum / static_cast<double>(parts.size());
}

Json tauCurve(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values) {
  ReductionOptions options;
  options.method = "qr";
  options.normalize = false;
  Json points = Json::array();
  for (const double tau : kTaus) {
    options.tau = tau;
    points.push_back({tau, supportVectors(reduce(machines, kernel_values, options)).size()});
  }
  return points;
}

/// Trains, tests and reduces the machines of one kernel and split.
Json evaluate(const Eigen::MatrixXd& gram, const SetSamples& samples, const Fold& fold,
              const SvmOptions& svm, bool with_curve, bool with_taus) {
  BinarySvms machines =
      trainMachines(submatrix(gram, fold.train, fold.train), pick(samples.places, fold.train),
                    static_cast<std::size_t>(samples.place_count), svm);
  const std::vector<int> vectors = supportVectors(machines);
  machines.weights = pickRows(machines.weights, vectors);
  const std::vector<int> columns = pick(fold.train, vectors);
  const Eigen::MatrixXd kernel_values = submatrix(gram, fold.train, columns);
  const Eigen::MatrixXd test_values = submatrix(gram, fold.test, columns);
  const RateOf rate = [&](const BinarySvms& reduced) {
    return meanRate(testCounts(samples, fold.test, answersOf(reduced, test_values)));
  };
  std::vector<ReductionCurve> curves;
  for (const bool normalize : {true, false}) {
    curves.push_back(reductionCurve(machines, kernel_values, "qr", normalize, rate));
  }
  Json result = {{"validation", validate(gram, samples, fold.train, svm)},
                 {"rate", curves[0].front().rate},
                 {"vectors", vectors.size()}};
  for (const int fraction : kMaterialFractions) {
    result["fewest"].push_back(fewestVectors(curves, fraction / 100.0));
  }
  if (with_curve) result["curve"] = toJson(curves[0]);
  if (with_taus) result["taus"] = tauCurve(machines, kernel_values);
  return result;
}

MaterialOutcome outcomeFrom(const Json& json) {
  MaterialOutcome outcome;
  outcome.validation = json.at("validation");
  outcome.rate = json.at("rate");
  outcome.vectors = json.at("vectors");
  outcome.fewest = json.at("fewest").get<std::vector<int>>();
  if (json.contains("curve")) outcome.curve = curveFromJson(json.at("curve"));
  if (!json.contains("taus")) return outcome;
  for (const Json& point : json.at("taus")) outcome.taus.push_back({point.at(0), point.at(1)});
  return outcome;
}

class MaterialsExperiment : public Experiment {
 public:
  MaterialsExperiment(std::vector<ImageSet> samples, unsigned threads)
      : sets_(std::move(samples)), threads_(threads) {
    if (sets_.size() < 3) {
      throw Error(
          "There are fewer than three samples of the materials; give a folder of "
          "MATERIAL/SAMPLE/IMAGE with three samples or more.");
    }
    splits_ = materialSplits(static_cast<int>(sets_.size()));
  }

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const char* feature : kMaterialFeatures) {
      for (const TrainingSamples& split : splits_) {
        for (const KernelOptions& kernel : materialKernels()) {
          cells.push_back(cellOf(feature, split, kernel));
        }
      }
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    std::size_t next = 0;  // cells are in the order of cells()
    for (const char* feature : kMaterialFeatures) {
      std::vector<TrainingSamples> splits;  // the requested ones
      std::vector<std::vector<const Json*>> wanted;
      for (const TrainingSamples& split : splits_) {
        std::vector<const Json*> of_split;
        for (const KernelOptions& kernel : materialKernels()) {
          const bool is_wanted =
              next < cells.size() && cellOf(feature, split, kernel) == cells[next];
          of_split.push_back(is_wanted ? &cells[next++] : nullptr);
        }
        if (std::all_of(of_split.begin(), of_split.end(), [](auto* cell) { return !cell; }))
          continue;
        splits.push_back(split);
        wanted.push_back(of_split);
      }
      if (splits.empty()) continue;
      const MaterialFeatures features =
          extractMaterials(feature, sets_, splits, threads_, progress);
      for (std::size_t i = 0; i < splits.size(); ++i) {
        report(progress, "Training and reducing", static_cast<double>(i) / splits.size());
        computeSplit(splits[i], wanted[i], features.samples, features.ofSplit(i), finished,
                     progress);
      }
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    const std::vector<KernelOptions> kernels = materialKernels();
    const std::vector<SvmOptions> svms = materialSvms();
    std::vector<MaterialResult> classifiers;
    std::map<int, std::vector<std::size_t>> splits_of;  // by the number of training samples
    for (std::size_t s = 0; s < splits_.size(); ++s) {
      splits_of[static_cast<int>(splits_[s].size())].push_back(s);
    }
    for (std::size_t f = 0; f < std::size(kMaterialFeatures); ++f) {
      for (const auto& [size, splits] : splits_of) {
        for (std::size_t k = 0; k < kernels.size(); ++k) {
          for (std::size_t i = 0; i < svms.size(); ++i) {
            MaterialResult& classifier = classifiers.emplace_back();
            classifier.classifier = {kMaterialFeatures[f], size, kernels[k], svms[i]};
            for (const std::size_t s : splits) {
              const Json& cell = results[(f * splits_.size() + s) * kernels.size() + k];
              classifier.outcomes.push_back(outcomeFrom(cell.at(i)));
            }
          }
        }
      }
    }
    return materialFindings(classifiers);
  }

 private:
  Json cellOf(const std::string& feature, const TrainingSamples& split,
              const KernelOptions& kernel) const {
    Json cell = {{"material", describeFeature(feature)},
                 {"feature", feature},
                 {"kernel", writeOptions(kernel)},
                 {"trained_on", Json::array()}};
    for (const int set : split) {
      cell["trained_on"].push_back(sets_[static_cast<std::size_t>(set)].name);
    }
    return cell;
  }

  /// `cells`: one per kernel; null if it is not requested.
  void computeSplit(const TrainingSamples& split, const std::vector<const Json*>& cells,
                    const SetSamples& samples, const std::vector<Feature>& features,
                    const CellSink& finished, const Progress& progress) const {
    const Fold fold = foldOf(samples, split);
    const std::vector<KernelOptions> kernels = materialKernels();
    const std::vector<SvmOptions> svms = materialSvms();
    const bool with_curve = split.size() + 1 == sets_.size();  // as in the thesis' tables
    std::string measured;
    Eigen::MatrixXd measures;
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      if (!cells[k]) continue;
      if (measured != kernels[k].type) {
        measures = measureMatrix(Kernel(kernels[k]), features, threads_, {});
        measured = kernels[k].type;
      }
      report(progress, "Training and reducing", static_cast<double>(k) / kernels.size());
      const Eigen::MatrixXd gram = gramMatrix(Kernel(kernels[k]), measures);
      std::vector<Json> results(svms.size());
      parallelFor(svms.size(), threads_, [&](std::size_t i, unsigned) {
        const bool in_figure_7_2 = with_curve && svms[i].c == 100 &&
                                   svms[i].multiclass == "one-against-one" &&
                                   kernels[k].type != "gaussian";
        results[i] = evaluate(gram, samples, fold, svms[i], with_curve, in_figure_7_2);
      });
      finished(*cells[k], results);
    }
  }

  std::vector<ImageSet> sets_;
  unsigned threads_;
  std::vector<TrainingSamples> splits_;
};

}  // namespace

std::unique_ptr<Experiment> materialsExperiment(std::vector<ImageSet> samples, unsigned threads) {
  return std::make_unique<MaterialsExperiment>(std::move(samples), threads);
}

}  // namespace place_recognition
