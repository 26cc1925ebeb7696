#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <numeric>
#include <optional>
#include <ostream>
#include <sstream>

#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/training.h"
#include "tool/configuration.h"
#include "tool/inputs.h"
#include "tool/other_runs.h"
#include "tool/output.h"
#include "tool/replacement.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct TrainOptions {
  std::vector<std::string> inputs;
  std::string model;
  std::string add_to;
  std::string from_model;
  std::vector<std::string> validate;
  int limit = 0;
  double forgetting = 0;
  unsigned threads = 0;
  InputOptions input;
  ConfigurationOptions configuration;
  OutputOptions output;
};

Json figures(const Training& training, const std::string& path, std::uint64_t bytes) {
  const Model& model = training.model;
  Json rooms = Json::object();
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    rooms[model.places[i]] = {{"count", model.provenance.place_images[i]}};
  }
  Json gamma = Json::object();
  for (const CueOptions& cue : model.options.cues) gamma[cue.name] = cue.kernel.gamma;
  return {{"images", training.images},
          {"rooms", rooms},
          {"support_vectors", model.supportVectorCount()},
          {"support_vectors_before",
           std::accumulate(training.unreduced_vectors.begin(), training.unreduced_vectors.end(),
                           std::uint64_t{0})},
          {"reduction",
           {{"method", model.options.reduction.method}, {"share", model.options.reduction.share}}},
          {"seconds", training.seconds},
          {"model_bytes", bytes},
          {"validation",
           {{"average_rate", model.validation.average_rate},
            {"calibration_error", model.validation.calibration_error},
            {"rooms", model.validatedPlaces()},
            {"block", model.options.validation.block},
            {"gap", model.options.validation.gap}}},
          {"model", path},
          {"gamma", gamma},
          {"passed_over", training.passed_over},
          {"skipped_images", model.provenance.skipped_images},
          {"warnings", training.warnings}};
}

/// Describes the held-out images on which the model was validated, and the result.
std::string heldOutText(const Model& model) {
  const std::vector<std::string> judged = model.validatedPlaces();
  if (judged.empty()) return "Not validated: too few images to hold any of them out.";
  const ValidationOptions& options = model.options.validation;
  std::ostringstream text;
  text << std::setprecision(options.block < 100 ? 2 : 6) << "Held-out ";
  if (options.block > 0) {
    text << "blocks of " << options.block << " s, " << options.gap
         << " s from what was trained on: ";
  } else {
    text << "runs: ";
  }
  text << std::fixed << std::setprecision(1) << 100 * model.validation.average_rate
       << " % right (mean of " << (judged.size() == model.places.size() ? "the places" : "");
  if (judged.size() < model.places.size()) text << listed(judged) << " only";
  text << "), calibration error " << std::setprecision(3) << model.validation.calibration_error;
  return text.str();
}

void printSummary(const Training& training, const std::string& path, std::uint64_t bytes,
                  const std::string& from_model, std::ostream& out) {
  const Model& model = training.model;
  out << "Learned " << model.places.size() << " places from " << training.images << " images";
  if (!from_model.empty()) out << " and the model " << from_model;
  if (training.passed_over > 0) out << " of " << training.images + training.passed_over;
  const std::vector<std::uint64_t>& counts = model.provenance.place_images;
  const bool continues =
      std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) > training.images;
  out << " in " << std::fixed << std::setprecision(1) << training.seconds << " s"
      << (continues ? "; with those learned before" : "") << ":\n";
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    out << std::setw(8) << counts[i] << "  " << model.places[i] << "\n";
  }
  out << heldOutText(model) << "\n" << std::defaultfloat << std::setprecision(4);
  for (std::size_t i = 0; i < model.options.cues.size(); ++i) {
    const CueOptions& cue = model.options.cues[i];
    out << "Cue " << cue.name << ": " << training.unreduced_vectors[i] << " support vectors, "
        << model.classifiers[i].supportVectorCount() << " after reduction ("
        << model.options.reduction.method << "), gamma " << cue.kernel.gamma << "\n";
  }
  out << "Model: " << path << ", " << std::max<std::uint64_t>(1, bytes / 1024) << " KiB"
      << std::endl;
}

/// The models from which a training continues, if any.
struct Sources {
  std::optional<Model> model;
  std::optional<Model> other;
};

Sources loadSources(const TrainOptions& options) {
  Sources sources;
  if (!options.add_to.empty()) sources.model = loadModel(modelPath(options.add_to));
  if (!options.from_model.empty()) sources.other = loadModel(modelPath(options.from_model));
  return sources;
}

/// Trains from scratch, or continues from a model, with or without another one.
Training learn(const TrainOptions& options, const Sources& sources,
               const std::vector<RecordingOpener>& recordings,
               const TrainingOptions& training_options, const Progress& progress,
               const AfterReading& after_reading) {
  if (!sources.model) {
    return place_recognition::train(recordings, training_options, options.threads, progress,
                                    after_reading);
  }
  IncrementalOptions incremental;
  incremental.vector_limit = options.limit;
  incremental.forgetting = options.forgetting;
  if (sources.other) incremental.other = &*sources.other;
  return trainIncrementally(*sources.model, recordings, incremental, options.threads, progress,
                            after_reading);
}

/// Judges the new model by the given runs against the model that it replaces or, if there is none,
/// the one that it continues from; nothing if the user gives no runs.
std::optional<Replacement> replacementOf(const TrainOptions& options, const Sources& sources,
                                         const std::string& path, ValidationRuns& runs,
                                         const Progress& progress) {
  if (options.validate.empty()) return std::nullopt;
  if (sources.model) runs.requireNotLearnedBy(*sources.model, modelPath(options.add_to));
  if (sources.other) runs.requireNotLearnedBy(*sources.other, modelPath(options.from_model));
  const bool goes_on = !std::filesystem::exists(path) && sources.model;
  return Replacement(runs, goes_on ? modelPath(options.add_to) : path, progress);
}

/// Throws UsageError for options that are missing or contradict each other.
void check(const TrainOptions& options) {
  if (options.inputs.empty() && options.from_model.empty()) {
    throw UsageError("INPUT is required: give a run to learn from");
  }
  const BagRecordingOptions& bag = options.input.bag;
  if (options.inputs.empty() && !(bag.label.empty() && bag.labels_file.empty())) {
    throw UsageError("--label and --labels apply to an INPUT; give one");
  }
  if (!options.from_model.empty() && modelPath(options.from_model) == modelPath(options.add_to)) {
    throw UsageError("--from-model and --add-to name the same model; give another one");
  }
  requireOtherRuns(options.validate, options.inputs);
  if (options.forgetting > 0 && options.limit == 0) {
    throw UsageError("--forgetting requires a --limit above 0");
  }
}

void train(const TrainOptions& options) {
  check(options);
  const TrainingOptions training_options = options.configuration.read();
  const std::string path = modelPath(options.model);
  requireWritable(path, Contents::kModel);
  const std::vector<RecordingOpener> recordings =
      options.input.openers(options.inputs, options.validate.empty());
  std::vector<RecordingOpener> others;
  if (!options.validate.empty()) {
    others = options.input.withoutLabels().openers(options.validate, false);
  }

  ProgressDisplay display(options.output.progress);
  const Sources sources = loadSources(options);
  ValidationRuns runs(std::move(others), display.callback());
  const std::optional<Replacement> replacement =
      replacementOf(options, sources, path, runs, display.callback());
  Training training = learn(
      options, sources, recordings, training_options, display.callback(),
      [&runs](const auto& learned, const auto& levels) { runs.requireNotAmong(learned, levels); });
  Replacement::Verdict verdict;
  if (replacement) verdict = replacement->judge(training.model, display.callback());
  if (!verdict.objection.empty()) {
    display.clear();
    printWarnings(verdict.warnings);
    throw Error(verdict.objection);
  }
  const std::uint64_t bytes = saveModel(training.model, path);
  display.clear();

  training.warnings.insert(training.warnings.end(), verdict.warnings.begin(),
                           verdict.warnings.end());
  printWarnings(training.warnings);
  printSummary(training, path, bytes, options.from_model, options.output.text());
  Json json = figures(training, path, bytes);
  if (replacement) {
    options.output.text() << "On the runs of --validate " << percent(verdict.rate)
                          << " right (mean of the rooms)" << std::endl;
    json["validate_rate"] = verdict.rate;
  }
  options.output.writeJson(json);
}

}  // namespace

void addTrain(CommandLine& tool) {
  Verb& verb = tool.verb("train", "Trains a model on labelled runs");
  const auto options = std::make_shared<TrainOptions>();
  verb.argument("INPUT", options->inputs, kInputHelp, false);
  verb.option("--model", "NAME", options->model,
              "Name of the model, or a file: a name with a slash or ending in .places")
      .required();
  verb.option("--add-to", "NAME", options->add_to,
              "Continue from this model: keep its features and its support vectors")
      .excludes("--config")
      .excludes("--set");
  verb.option("--from-model", "NAME", options->from_model,
              "With --add-to: also learn the support vectors of this model of another robot; INPUT "
              "is then optional. Both models must have been trained with the same configuration")
      .needs("--add-to");
  verb.option("--limit", "N", options->limit,
              "With --add-to: most support vectors that each cue may keep; 0: as many as it needs")
      .needs("--add-to")
      .range(0, 1000000);
  verb.option("--forgetting", "FRACTION", options->forgetting,
              "With --limit: fraction by which the weight of a view falls each time that its room "
              "is learned again, 0..0.99; 0: forgetting does not depend on age")
      .needs("--limit")
      .range(0, 0.99);
  verb.option("--validate", "RUN", options->validate,
              "Replace the model only if the new one is not worse, by more than a standard error, "
              "on this labelled run; neither model may have been trained on it");
  options->configuration.addTo(verb);
  options->input.addTo(verb);
  addThreads(verb, options->threads);
  options->output.addTo(verb);
  verb.footer(
      "Example:\n"
      "  place_tool train monday.bag tuesday.bag --model office --config crfh_colour\n"
      "  place_tool train wednesday.bag --add-to office --limit 500 --model office\n"
      "  place_tool train --add-to office --from-model other_robot --model both");
  verb.run([options] { train(*options); });
}

}  // namespace place_recognition::tool
