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

void reduceModel(const ReduceOptions& options) {
  const std::string path = modelPath(options.out);
  requireWritable(path);
  Model model = loadModel(modelPath(options.model));
  const std::size_t before = model.supportVectorCount();
  options.reduction.check();

  ProgressDisplay display(options.output.progress);
  const Progress progress = display.callback();
  const auto collect = [&](const std::vector<std::string>& inputs) {
    return collectSamples(options.input.openers(inputs), model.options, 0, progress);
  };
  Samples training;
  if (!options.train.empty()) training = collect(options.train);
  const ModelReduction reduction(model, options.train.empty() ? nullptr : &training, progress);

  ReductionOptions chosen = options.reduction;
  Json validation;
  if (!options.validate.empty()) {
    const RateOnSamples rate(model, collect(options.validate), progress);
    chosen = searchByLoss(model, reduction, rate, options, progress);
    validation["average_rate_before"] = rate(machinesOf(model));
    validation["average_rate_after"] = rate(reduction.reduce(chosen, {}).machines);
  }
  ReducedMachines reduced = reduction.reduce(chosen, progress);
  const double max_change = reduced.max_margin_change;
  const double mean_change = reduced.mean_margin_change;
  model = withMachines(std::move(model), std::move(reduced), chosen);
  const std::uint64_t bytes = saveModel(model, path);
  display.clear();

  const std::size_t after = model.supportVectorCount();
  std::ostream& out = options.output.text();
  out << "Support vectors: " << before << " -> " << after << std::fixed << std::setprecision(1)
      << " (" << 100.0 * after / std::max<std::size_t>(1, before) << " %)\n"
      << std::scientific << std::setprecision(2) << "Change of the margins: " << max_change
      << " at most, " << mean_change << " in the mean\n";
  if (!validation.is_null()) {
    out << std::fixed << std::setprecision(1)
        << "Rate: " << 100 * validation["average_rate_before"].get<double>() << " % -> "
        << 100 * validation["average_rate_after"].get<double>() << " %\n";
  }
  out << "Model: " << path << ", " << std::max<std::uint64_t>(1, bytes / 1024) << " KiB"
      << std::endl;
  Json figures = {{"support_vectors_before", before},
                  {"support_vectors_after", after},
                  {"max_margin_change", max_change},
                  {"mean_margin_change", mean_change},
                  {"model_bytes", bytes},
                  {"model", path}};
  if (!validation.is_null()) figures["validation"] = validation;
  options.output.writeJson(figures);
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
