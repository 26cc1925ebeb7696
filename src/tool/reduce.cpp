#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <ostream>

#include "learning/classifier_parts.h"
#include "learning/reduction.h"
#include "place_recognition/model_file.h"
#include "recognition/training/model_reduction.h"
#include "recognition/training/reduction_sweep.h"
#include "tool/inputs.h"
#include "tool/other_runs.h"
#include "tool/output.h"
#include "tool/reduction_report.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct ReduceOptions {
  std::string model;
  std::string out;
  std::string report;
  std::vector<std::string> train;
  std::vector<std::string> validate;
  double max_loss = -1;  // percentage points; negative: no search
  ReductionOptions reduction;
  InputOptions input;
  OutputOptions output;
};

/// Reduces one model by any method, and measures the effect.
class Reducer {
 public:
  Reducer(const ReduceOptions& options, const Progress& progress)
      : options_(options),
        progress_(progress),
        model_(loadModel(modelPath(options.model))),
        model_bytes_(std::filesystem::file_size(modelPath(options.model))),
        validation_(collectValidation()),
        training_(collectTraining()),
        reduction_(model_, options.train.empty() ? nullptr : &training_, progress) {
    if (!options.validate.empty()) {
      rate_ = std::make_unique<RateOnSamples>(model_, validation_, progress);
      rate_before_ = (*rate_)(machinesOf(model_));
    }
  }

  ReductionFigures before() const {
    ReductionFigures figures = measured(model_);
    figures.method = "before";
    figures.model_bytes = model_bytes_;
    if (rate_) figures.rate = rate_before_;
    return figures;
  }

  /// Saves the reduced model unless `path` is empty.
  ReductionFigures reduce(const std::string& method, const std::string& path) const {
    ReductionOptions chosen = options_.reduction;
    chosen.method = method;
    std::vector<std::pair<double, double>> curve;
    if (rate_) {
      const ReductionSweep sweep(model_, reduction_, *rate_, chosen, progress_);
      if (options_.max_loss >= 0) {
        chosen.support_vectors = sweep.fewest(rate_before_ - options_.max_loss / 100, progress_);
      }
      if (!options_.report.empty()) curve = sweep.curve();
    }
    std::vector<BinarySvms> machines = reduction_.reduce(chosen, progress_);
    const DecisionValueChange change = reduction_.change(machines);
    std::optional<double> rate;
    if (rate_) rate = (*rate_)(machines);

    const Model smaller = withMachines(model_, std::move(machines), chosen);
    ReductionFigures figures = measured(smaller);
    figures.method = method;
    figures.model_bytes = path.empty() ? serializeModel(smaller).size() : saveModel(smaller, path);
    figures.change = change;
    figures.rate = rate;
    figures.curve = std::move(curve);
    return figures;
  }

  std::string valuesOf() const {
    if (options_.train.empty()) {
      return "the model's own support vectors, the only images in the model (give --train for "
             "all images)";
    }
    return "the " + std::to_string(training_.origins.size()) + " images given by --train";
  }

  /// About the runs and their images, for a person.
  std::vector<std::string> warnings() const {
    std::vector<std::string> warnings = training_.warnings;
    warnings.insert(warnings.end(), validation_.warnings.begin(), validation_.warnings.end());
    return warnings;
  }

 private:
  bool readsBoth() const { return !options_.train.empty() && !options_.validate.empty(); }

  /// The images as recorded, because a rate on made-up ones is not that of a run.
  Samples collectValidation() const {
    if (options_.validate.empty()) return {};
    const InputOptions input = readsBoth() ? options_.input.withoutLabels() : options_.input;
    const std::vector<RecordingOpener> runs = input.openers(options_.validate, !readsBoth());
    TrainingOptions options = model_.options;
    options.augmentation.other_light = false;
    Samples samples = collectSamplesFor(model_, runs, options, 0, progress_, 1);
    requireNotLearned(model_, modelPath(options_.model), samples.inputs, samples.sketches);
    return samples;
  }

  Samples collectTraining() const {
    if (options_.train.empty()) return {};
    Samples samples =
        collectSamplesFor(model_, options_.input.openers(options_.train, !readsBoth()),
                          model_.options, 0, progress_, 1);
    warnOfOtherRuns(samples);
    return samples;
  }

  /// Warns of runs of --train that the model was not trained on, if its sketches can tell.
  void warnOfOtherRuns(Samples& samples) const {
    const std::vector<RunSketch>& learned = model_.provenance.sketches;
    const auto unknown = std::mem_fn(&RunSketch::empty);
    if (std::any_of(learned.begin(), learned.end(), unknown)) return;
    for (std::size_t i = 0; i < samples.inputs.size(); ++i) {
      if (samples.sketches[i].empty() || isLearned(samples.sketches[i], learned)) continue;
      samples.warnings.push_back("--train: " + modelPath(options_.model) + " was not trained on " +
                                 samples.inputs[i] + "; give the runs that it was trained on.");
    }
  }

  ReductionFigures measured(const Model& model) const {
    ReductionFigures figures;
    figures.support_vectors = model.supportVectorCount();
    figures.comparison_ms = comparisonMilliseconds(model, images());
    return figures;
  }

  /// Features for measuring time, [cue][image].
  std::vector<std::vector<Feature>> images() const {
    if (rate_) return validation_.features;
    if (!options_.train.empty()) return training_.features;
    std::vector<std::vector<Feature>> features;
    for (const Classifier& classifier : model_.classifiers) {
      features.push_back(ClassifierParts::of(classifier).support_set.vectors());
    }
    return features;
  }

  const ReduceOptions& options_;
  const Progress& progress_;
  Model model_;
  std::uint64_t model_bytes_;  // of its file
  Samples validation_;
  Samples training_;
  ModelReduction reduction_;
  std::unique_ptr<RateOnSamples> rate_;  // on the validation runs, if there are any
  double rate_before_ = 0;
};

void reduceModel(const ReduceOptions& options) {
  options.reduction.check();
  requireOtherRuns(options.validate, options.train);
  const std::string path = modelPath(options.out);
  const std::string page = options.report + "/reduction.html";
  requireWritable(path, Contents::kModel);
  if (!options.report.empty()) requireWritable(page, Contents::kText);

  ProgressDisplay display(options.output.progress);
  const Progress progress = display.callback();
  const Reducer reducer(options, progress);
  ReductionReport report{path, reducer.valuesOf(), reducer.before(), {}, reducer.warnings()};
  report.methods.push_back(reducer.reduce(options.reduction.method, path));
  for (const char* method : kReductionMethods) {
    if (options.report.empty() || method == options.reduction.method) continue;
    report.methods.push_back(reducer.reduce(method, ""));
  }
  display.clear();

  printWarnings(report.warnings);
  options.output.text() << reductionTable(report) << "Model: " << path << std::endl;
  if (!options.report.empty()) {
    writeText(page, reductionPage(report));
    options.output.text() << "Report: " << page << std::endl;
  }
  options.output.writeJson(reductionJson(report));
}

}  // namespace

void addReduce(CommandLine& tool) {
  Verb& verb = tool.verb("reduce", "Makes a model smaller and faster");
  const auto options = std::make_shared<ReduceOptions>();
  options->reduction.method = "shared-greedy";
  verb.option("--model", "NAME", options->model, "Name or file of the model").required();
  verb.option("--out", "NAME2", options->out, "Name or file of the reduced model").required();
  verb.option("--method", "NAME", options->reduction.method,
              "shared-greedy (default), shared-qr: one basis for all machines; qr: each machine "
              "separately")
      .oneOf({std::begin(kReductionMethods), std::end(kReductionMethods)});
  verb.flag("--normalize", options->reduction.normalize,
            "Scale the columns of the kernel matrix to norm one first (default)");
  verb.flag("--no-normalize", options->reduction.normalize, "Do not scale them", false)
      .excludes("--normalize");
  verb.option("--tau", "T", options->reduction.tau, "Rank threshold, 0..1 (default 0.01)");
  verb.option("--support-vectors", "N", options->reduction.support_vectors,
              "Number of vectors of each cue to keep")
      .positive()
      .excludes("--tau");
  verb.option("--share", "S", options->reduction.share,
              "Fraction of each cue's vectors to keep, 0..1")
      .range(1e-6, 1)
      .excludes("--tau")
      .excludes("--support-vectors");
  verb.option("--max-loss", "PERCENT", options->max_loss,
              "Keep the fewest vectors whose rate on --validate falls by at most this much, in "
              "percentage points")
      .range(0, 100)
      .needs("--validate")
      .excludes("--tau")
      .excludes("--support-vectors")
      .excludes("--share");
  verb.option("--validate", "INPUT", options->validate,
              "Labelled runs on which the rate is measured before and after; the model must not "
              "have been trained on them")
      .many();
  verb.option("--train", "INPUT", options->train,
              "The runs that the model was trained on: decision values are then preserved on all "
              "their images; otherwise only on the support vectors, the only images in the model")
      .many();
  verb.option("--report", "DIR", options->report,
              "Compare all three methods in the table and in DIR/reduction.html; with --validate "
              "also curves of the rate against the number of vectors");
  options->input.addTo(verb);
  options->output.addTo(verb);
  verb.footer(
      "Example:\n"
      "  place_tool reduce --model office --out office_small --max-loss 1 --validate tuesday.bag");
  verb.run([options] { reduceModel(*options); });
}

}  // namespace place_recognition::tool
