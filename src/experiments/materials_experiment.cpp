#include "experiments/materials_experiment.h"

#include <atomic>
#include <cmath>
#include <cstdio>

#include "base/options.h"
#include "base/parallel.h"
#include "experiments/materials_tables.h"
#include "experiments/reduction_curve.h"
#include "learning/gram.h"
#include "learning/reduction.h"
#include "place_recognition/error.h"
#include "recognition/training/samples.h"

namespace place_recognition {
namespace {

constexpr const char* kFeatures[] = {"mr8", "lbp"};
constexpr double kTaus[] = {1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3};

TrainingOptions trainingOptions(const std::string& feature) {
  TrainingOptions options;
  CueOptions cue;
  cue.name = feature;
  if (feature == "mr8") cue.feature = Mr8Options();
  if (feature == "lbp") cue.feature = LbpOptions();
  options.cues = {cue};
  return options;
}

/// The kernels of section 7.2.
std::vector<KernelOptions> kernels() {
  std::vector<KernelOptions> kernels;
  KernelOptions kernel;
  for (const char* type : {"chi-squared", "gaussian"}) {
    kernel.type = type;
    for (int power = -3; power <= 3; ++power) {
      kernel.gamma = std::pow(10, power);
      kernels.push_back(kernel);
    }
  }
  kernel = KernelOptions();
  kernel.type = "polynomial";
  for (const double p : {0, 1}) {
    kernel.p = p;
    for (kernel.d = 1; kernel.d <= 5; ++kernel.d) kernels.push_back(kernel);
  }
  return kernels;
}

std::vector<MaterialClassifier> allClassifiers() {
  std::vector<MaterialClassifier> classifiers;
  for (const char* feature : kFeatures) {
    for (const char* multiclass : {"one-against-one", "one-against-all"}) {
      for (const KernelOptions& kernel : kernels()) {
        classifiers.push_back({feature, kernel, {100, multiclass}});
        const bool in_table_7_2 = std::string(feature) == "mr8" && kernel.type == "gaussian" &&
                                  kernel.gamma == std::pow(10, -2) &&
                                  std::string(multiclass) == "one-against-one";
        if (!in_table_7_2) continue;
        for (const double c : {1, 10, 1000}) {
          classifiers.push_back({feature, kernel, {c, multiclass}});
        }
      }
    }
  }
  return classifiers;
}

/// All samples' places and sets, in the order of their features.
SetSamples setSamplesOf(const Samples& samples, std::size_t set_count) {
  SetSamples result;
  result.place_count = static_cast<int>(samples.places.size());
  result.set_count = static_cast<int>(set_count);
  for (const SampleOrigin& origin : samples.origins) {
    result.places.push_back(origin.place);
    result.sets.push_back(origin.run);
  }
  return result;
}

/// Mean rate on each sample of `train` when it is left out of it.
double validate(const Eigen::MatrixXd& gram, const SetSamples& samples,
                const std::vector<int>& train, const SvmOptions& svm) {
  double sum = 0;
  int count = 0;
  for (int set = 0; set < samples.set_count; ++set) {
    Fold fold;
    for (const int i : train) {
      (samples.sets[static_cast<std::size_t>(i)] == set ? fold.test : fold.train).push_back(i);
    }
    if (fold.test.empty()) continue;
    sum += rateOf(gram, samples, fold, svm);
    ++count;
  }
  return sum / count;
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

}  // namespace

std::string describe(const KernelOptions& kernel) {
  char text[64];
  if (kernel.type == "polynomial") {
    std::snprintf(text, sizeof(text), "polynomial p=%g d=%d", kernel.p, kernel.d);
  } else {
    std::snprintf(text, sizeof(text), "%s gamma=%g", kernel.type.c_str(), kernel.gamma);
  }
  return text;
}

MaterialsExperiment::MaterialsExperiment(std::vector<PictureSet> samples, unsigned threads)
    : sets_(std::move(samples)), threads_(threads), classifiers_(allClassifiers()) {
  if (sets_.size() < 3) {
    throw Error(
        "There are fewer than three samples of the materials; give a folder of "
        "MATERIAL/SAMPLE/PICTURE with three samples or more.");
  }
}

Json MaterialsExperiment::cellOf(const MaterialClassifier& classifier,
                                 const PictureSet& tested) const {
  return {{"material", writeOptions(trainingOptions(classifier.feature).cues[0])},
          {"feature", classifier.feature},
          {"kernel", writeOptions(classifier.kernel)},
          {"svm", writeOptions(classifier.svm)},
          {"test_set", tested.name}};
}

std::vector<Json> MaterialsExperiment::cells() const {
  std::vector<Json> cells;
  for (const MaterialClassifier& classifier : classifiers_) {
    for (const PictureSet& tested : sets_) cells.push_back(cellOf(classifier, tested));
  }
  return cells;
}

void MaterialsExperiment::compute(const std::vector<Json>& cells, const CellSink& finished,
                                  const Progress& progress) {
  std::size_t next = 0;  // cells come in the order of cells()
  for (const char* feature : kFeatures) {
    struct Task {
      const MaterialClassifier* classifier;
      int tested;
      const Json* cell;
    };
    std::vector<Task> tasks;
    for (const MaterialClassifier& classifier : classifiers_) {
      if (classifier.feature != feature) continue;
      for (std::size_t set = 0; set < sets_.size() && next < cells.size(); ++set) {
        if (cellOf(classifier, sets_[set]) != cells[next]) continue;
        tasks.push_back({&classifier, static_cast<int>(set), &cells[next++]});
      }
    }
    if (tasks.empty()) continue;

    std::vector<RunOpener> runs;
    for (const PictureSet& set : sets_) runs.push_back([&set] { return openPictureSet(set); });
    const Samples samples = collectSamples(runs, trainingOptions(feature), threads_, progress);
    const SetSamples set_samples = setSamplesOf(samples, sets_.size());
    std::string measured;
    Eigen::MatrixXd measures;
    constexpr std::size_t kAtOnce = 16;  // cells between two looks at whether to stop
    for (std::size_t begin = 0, end = 0; begin < tasks.size(); begin = end) {
      const KernelOptions& kernel = tasks[begin].classifier->kernel;
      if (measured != kernel.type) {
        measures = measureMatrix(Kernel(kernel), samples.features[0], threads_, {});
        measured = kernel.type;
      }
      while (end < tasks.size() && end < begin + kAtOnce &&
             tasks[end].classifier->kernel.type == measured) {
        ++end;
      }
      report(progress, "Training and reducing", static_cast<double>(begin) / tasks.size());
      std::vector<Json> results(end - begin);
      parallelFor(results.size(), threads_, [&](std::size_t i, unsigned) {
        const Task& task = tasks[begin + i];
        results[i] = evaluate(*task.classifier, task.tested, set_samples, measures);
      });
      for (std::size_t i = 0; i < results.size(); ++i) finished(*tasks[begin + i].cell, results[i]);
    }
  }
}

Json MaterialsExperiment::evaluate(const MaterialClassifier& classifier, int tested,
                                   const SetSamples& samples,
                                   const Eigen::MatrixXd& measures) const {
  const Eigen::MatrixXd gram = gramMatrix(Kernel(classifier.kernel), measures);
  Fold fold = samples.split(tested);
  std::swap(fold.train, fold.test);  // here one set is tested and all others are trained on
  BinarySvms machines =
      trainMachines(submatrix(gram, fold.train, fold.train), pick(samples.places, fold.train),
                    static_cast<std::size_t>(samples.place_count), classifier.svm);
  const std::vector<int> vectors = supportVectors(machines);
  Eigen::MatrixXd weights(vectors.size(), machines.weights.cols());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    weights.row(static_cast<Eigen::Index>(i)) = machines.weights.row(vectors[i]);
  }
  machines.weights = weights;
  const std::vector<int> columns = pick(fold.train, vectors);
  const Eigen::MatrixXd kernel_values = submatrix(gram, fold.train, columns);
  const Eigen::MatrixXd test_values = submatrix(gram, fold.test, columns);
  const RateOf rate = [&](const BinarySvms& reduced) {
    return meanRate(testCounts(samples, fold.test, answersOf(reduced, test_values)));
  };

  Json result = {{"validation", validate(gram, samples, fold.train, classifier.svm)}};
  for (const bool normalize : {true, false}) {
    result["curves"].push_back(
        toJson(reductionCurve(machines, kernel_values, "qr", normalize, rate)));
  }
  const bool in_figure_7_2 =
      classifier.svm.multiclass == "one-against-one" && classifier.kernel.type != "gaussian";
  if (in_figure_7_2) result["taus"] = tauCurve(machines, kernel_values);
  return result;
}

Findings MaterialsExperiment::findings(const std::vector<Json>& results) const {
  std::vector<MaterialResult> classifiers;
  for (std::size_t i = 0; i < classifiers_.size(); ++i) {
    MaterialResult& classifier = classifiers.emplace_back();
    classifier.classifier = classifiers_[i];
    for (std::size_t set = 0; set < sets_.size(); ++set) {
      const Json& result = results[i * sets_.size() + set];
      classifier.validation += result.at("validation").get<double>() / sets_.size();
      std::vector<ReductionCurve>& curves = classifier.curves.emplace_back();
      for (const Json& curve : result.at("curves")) curves.push_back(curveFromJson(curve));
      if (!result.contains("taus")) continue;
      std::vector<TauPoint>& taus = classifier.taus.emplace_back();
      for (const Json& point : result.at("taus")) taus.push_back({point.at(0), point.at(1)});
    }
  }
  return materialFindings(classifiers);
}

}  // namespace place_recognition
