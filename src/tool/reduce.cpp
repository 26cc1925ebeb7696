#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "place_recognition/model_file.h"
#include "tool/inputs.h"
#include "tool/model_reduction.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct ReduceOptions {
  std::string model;
  std::string out;
  std::vector<std::string> train;
  std::vector<std::string> validate;
  double max_loss = 0;  // percentage points
  ReductionOptions reduction;
  InputOptions input;
  OutputOptions output;
};

/// The fewest vectors a cue whose rate on the validation runs stays within the loss, by bisection:
/// the rate need not fall evenly with them, so there may be fewer still.
ReductionOptions searchByLoss(const Model& model, const ModelReduction& reduction,
                              const RateOnSamples& rate, const ReduceOptions& options,
                              const Progress& progress) {
  const double wanted = rate(machinesOf(model)) - options.max_loss / 100;
  int enough = 1;
  for (const Classifier& classifier : model.classifiers) {
    enough = std::max(enough, static_cast<int>(classifier.supportVectorCount()));
  }
  int too_few = 0;
  ReductionOptions tried = options.reduction;
  const int span = enough;
  while (enough - too_few > 1) {
    report(progress, "Searching for the fewest vectors",
           1 - static_cast<double>(enough - too_few) / span);
    tried.support_vectors = (enough + too_few) / 2;
    const bool holds = rate(reduction.reduce(tried, {}).machines) >= wanted;
    (holds ? enough : too_few) = tried.support_vectors;
  }
  tried.support_vectors = enough;
  return tried;
}

/// What a reduction did.
struct Outcome {
  std::size_t before = 0;  // support vectors
  std::size_t after = 0;
  double max_margin_change = 0;
  double mean_margin_change = 0;
  std::uint64_t bytes = 0;
  bool validated = false;
  double rate_before = 0;  // on the validation runs
  double rate_after = 0;
};

void printOutcome(const Outcome& outcome, const std::string& path, std::ostream& out) {
  const double share = 100.0 * static_cast<double>(outcome.after) /
                       static_cast<double>(std::max<std::size_t>(1, outcome.before));
  out << "Support vectors: " << outcome.before << " -> " << outcome.after << std::fixed
      << std::setprecision(1) << " (" << share << " %)\n"
      << std::scientific << "Change of the margins: " << outcome.max_margin_change << " at most, "
      << outcome.mean_margin_change << " in the mean\n"
      << std::fixed;
  if (outcome.validated) {
    out << "Rate: " << 100 * outcome.rate_before << " % -> " << 100 * outcome.rate_after << " %\n";
  }
  out << "Model: " << path << ", " << std::max<std::uint64_t>(1, outcome.bytes / 1024) << " KiB"
      << std::endl;
}

Json figures(const Outcome& outcome, const std::string& path) {
  Json figures = {{"support_vectors_before", outcome.before},
                  {"support_vectors_after", outcome.after},
                  {"max_margin_change", outcome.max_margin_change},
                  {"mean_margin_change", outcome.mean_margin_change},
                  {"model_bytes", outcome.bytes},
                  {"model", path}};
  if (outcome.validated) {
    figures["validation"] = {{"average_rate_before", outcome.rate_before},
                             {"average_rate_after", outcome.rate_after}};
  }
  return figures;
}

/// Reduces `model`, replaces `path` by the result and tells what that did.
Outcome reduceTo(const std::string& path, Model model, const ReduceOptions& options,
                 const Progress& progress) {
  const auto collect = [&](const std::vector<std::string>& inputs) {
    return collectSamples(options.input.openers(inputs), model.options, 0, progress);
  };
  Samples training;
  if (!options.train.empty()) training = collect(options.train);
  const ModelReduction reduction(model, options.train.empty() ? nullptr : &training, progress);

  Outcome outcome;
  ReductionOptions chosen = options.reduction;
  if (!options.validate.empty()) {
    const RateOnSamples rate(model, collect(options.validate), progress);
    chosen = searchByLoss(model, reduction, rate, options, progress);
    outcome.validated = true;
    outcome.rate_before = rate(machinesOf(model));
    outcome.rate_after = rate(reduction.reduce(chosen, {}).machines);
  }
  ReducedMachines reduced = reduction.reduce(chosen, progress);
  outcome.before = model.supportVectorCount();
  outcome.max_margin_change = reduced.max_margin_change;
  outcome.mean_margin_change = reduced.mean_margin_change;
  const Model smaller = withMachines(std::move(model), std::move(reduced), chosen);
  outcome.after = smaller.supportVectorCount();
  outcome.bytes = saveModel(smaller, path);
  return outcome;
}

void reduceModel(const ReduceOptions& options) {
  options.reduction.check();
  const std::string path = modelPath(options.out);
  requireWritable(path);
  ProgressDisplay display(options.output.progress);
  const Outcome outcome =
      reduceTo(path, loadModel(modelPath(options.model)), options, display.callback());
  display.clear();
  printOutcome(outcome, path, options.output.text());
  options.output.writeJson(figures(outcome, path));
}

}  // namespace

void addReduce(CLI::App& tool) {
  CLI::App* verb = tool.add_subcommand("reduce", "Makes a model smaller and quicker");
  const auto options = std::make_shared<ReduceOptions>();
  options->reduction.method = "qr";
  verb->add_option("--model", options->model, "Name or file of the model")
      ->type_name("NAME")
      ->required();
  verb->add_option("--out", options->out, "Name or file of the reduced model")
      ->type_name("NAME2")
      ->required();
  verb->add_option("--method", options->reduction.method,
                   "qr (default): each machine by itself; shared-qr, shared-greedy: one basis for "
                   "all machines")
      ->check(CLI::IsMember({"qr", "shared-qr", "shared-greedy"}));
  CLI::Option* tau =
      verb->add_option("--tau", options->reduction.tau, "Rank threshold, 0..1 (default 0.01)")
          ->type_name("T");
  CLI::Option* count = verb->add_option("--support-vectors", options->reduction.support_vectors,
                                        "Number of vectors to keep, of each cue")
                           ->type_name("N")
                           ->check(CLI::PositiveNumber)
                           ->excludes(tau);
  CLI::Option* loss = verb->add_option("--max-loss", options->max_loss,
                                       "Fewest vectors that lose no more than this of the rate on "
                                       "--validate, percentage points")
                          ->type_name("PERCENT")
                          ->check(CLI::Range(0.0, 100.0))
                          ->excludes(tau)
                          ->excludes(count);
  CLI::Option* validate =
      verb->add_option("--validate", options->validate, "Labelled runs to measure the loss on")
          ->type_name("INPUT...")
          ->needs(loss);
  loss->needs(validate);
  verb->add_option("--train", options->train,
                   "The runs that the model was trained on: the margins are then kept on all of "
                   "their pictures. Without it on the support vectors only, all that the model "
                   "has of them")
      ->type_name("INPUT...");
  options->input.addTo(*verb);
  options->output.addTo(*verb);
  verb->footer(
      "Example:\n"
      "  place_tool reduce --model office --out office_small --method shared-qr --max-loss 1 "
      "--validate tuesday.bag");
  verb->callback([options] { reduceModel(*options); });
}

}  // namespace place_recognition::tool
