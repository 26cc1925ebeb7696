#include <iostream>
#include <memory>

#include "base/parallel.h"
#include "datasets/image_file.h"
#include "experiments/experiment_run.h"
#include "experiments/experiments.h"
#include "experiments/layout_sets.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/part_option.h"
#include "tool/unusable_images.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct ExperimentOptions {
  std::string name;
  std::string data;
  std::string out;
  std::string layout = "indecs";
  std::string part = "1/1";
  int every = 1;
  int max_dimensions = 16;
  unsigned threads = 0;
  OutputOptions output;
};

std::unique_ptr<Experiment> makeExperiment(const ExperimentOptions& options,
                                           std::vector<ImageSet> sets) {
  const unsigned threads = options.threads;
  if (options.name == "indecs-local") {
    return finalExperiment(PlaceFeatures::kLocal, std::move(sets), threads);
  }
  if (options.name == "indecs-global") {
    return finalExperiment(PlaceFeatures::kGlobal, std::move(sets), threads);
  }
  if (options.name == "reduction") return reductionExperiment(std::move(sets), threads);
  if (options.name == "materials") return materialsExperiment(std::move(sets), threads);
  if (options.name == "learning-curve") return learningCurveExperiment(std::move(sets), threads);
  if (options.name == "categories") return categoriesExperiment(std::move(sets), threads);
  if (options.name == "cues") return cuesExperiment(std::move(sets), threads);
  if (options.name == "figures") return figuresExperiment();
  if (options.name == "bins") return binsExperiment(std::move(sets), threads);
  return descriptorsExperiment(std::move(sets), options.max_dimensions, threads);
}

/// Throws UsageError for an option that this experiment does not have.
void requireApplicable(const ExperimentOptions& options) {
  const ExperimentOptions defaults;
  const bool made_up = options.name == "figures";
  if (options.layout != defaults.layout && (made_up || options.name == "materials")) {
    throw UsageError("--layout applies to images of places");
  }
  if (options.every != defaults.every && made_up) throw UsageError("--every requires --data");
  if (options.max_dimensions != defaults.max_dimensions && options.name != "descriptors") {
    throw UsageError("--max-dimensions applies to descriptors");
  }
}

/// Warns of folders without images.
std::vector<ImageSet> setsOf(const ExperimentOptions& options) {
  const bool made_up = options.name == "figures";
  if (made_up && !options.data.empty()) {
    throw UsageError("--data: the figures use artificial points; omit it");
  }
  if (!made_up && options.data.empty()) throw UsageError("--data is required");
  if (made_up) return {};
  if (options.name == "materials") return sampleSets(options.data);
  std::vector<std::string> warnings;
  std::vector<ImageSet> sets = options.name == "categories"
                                   ? buildingSets(options.data, options.layout, warnings)
                                   : conditionSets(options.data, options.layout, warnings);
  printWarnings(warnings);
  return sets;
}

/// Leaves the images out of `set` that cannot be read, and says so. Returns their number.
std::size_t leaveOutUnusable(ImageSet& set, unsigned threads, ProgressDisplay& display) {
  const Progress progress = display.callback();
  std::vector<std::string> problems(set.images.size());
  parallelFor(problems.size(), threads, [&](std::size_t i, unsigned thread) {
    if (thread == 0)
      report(progress, "Checking " + set.name, static_cast<double>(i) / problems.size());
    problems[i] = readDeepImageFile(set.images[i].path).problem;
  });
  UnusableImages unusable;
  std::vector<LabelledImage> usable;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    if (problems[i].empty()) {
      usable.push_back(set.images[i]);
    } else {
      unusable.add(set.images[i].path, problems[i]);
    }
  }
  display.clear();
  unusable.requireOthers(problems.size());
  unusable.warn(std::cerr);
  set.images = std::move(usable);
  return unusable.count();
}

void runExperimentVerb(const ExperimentOptions& options) {
  requireApplicable(options);
  const Part part = parsePart(options.part);
  std::vector<ImageSet> sets = setsOf(options);
  const NewFolder folder(options.out);
  ProgressDisplay display(options.output.progress);
  std::size_t images = 0, unusable = 0;
  for (ImageSet& set : sets) {
    set = thinnedOut(set, options.every);
    unusable += leaveOutUnusable(set, options.threads, display);
    images += set.images.size();
  }
  const std::string digest = digestOf(sets);
  const std::unique_ptr<Experiment> experiment = makeExperiment(options, std::move(sets));
  const ExperimentOutcome outcome =
      runExperiment(*experiment, options.out, digest, part, display.callback());
  display.clear();
  printWarnings(experiment->warnings());
  std::ostream& out = options.output.text();
  if (outcome.missing == 0) {
    out << outcome.text << "\nTables, figures and results: " << options.out << std::endl;
  }
  out << outcome.cells << " cells, " << outcome.computed << " computed now";
  if (outcome.missing > 0) out << ", " << outcome.missing << " still missing";
  out << "; " << images << " images" << std::endl;
  options.output.writeJson({{"experiment", options.name},
                            {"cells", outcome.cells},
                            {"computed", outcome.computed},
                            {"missing", outcome.missing},
                            {"pictures", images},
                            {"unusable_images", unusable},
                            {"warnings", experiment->warnings()}});
}

}  // namespace

void addExperiment(CommandLine& tool) {
  Verb& verb = tool.verb("experiment", "Repeats an experiment of the thesis");
  const auto options = std::make_shared<ExperimentOptions>();
  verb.argument("NAME", options->name,
                "indecs-local, indecs-global: Tables 8.2, 8.6; descriptors: 8.4; bins: 8.5; "
                "reduction: 8.3, 8.7; materials: 7.1 to 7.6; figures: 5.5, 6.1, 6.2, without "
                "--data; learning-curve: number of images and viewpoints needed; categories: rooms "
                "of a building outside the training set; cues: ways of combining several")
      .oneOf({"indecs-local", "indecs-global", "descriptors", "bins", "reduction", "materials",
              "figures", "learning-curve", "categories", "cues"});
  verb.option("--data", "DIR", options->data,
              "Folder of images: CONDITION/ROOM/IMAGE; materials: MATERIAL/SAMPLE/IMAGE; "
              "categories: BUILDING/CONDITION/ROOM/IMAGE");
  verb.option("--out", "DIR", options->out,
              "Folder for the tables and the finished cells, which are not computed again")
      .required();
  verb.option("--layout", "NAME", options->layout,
              "Layout of the images of places: indecs (default); idol, cold: a folder of sequences")
      .oneOf({"indecs", "idol", "cold"});
  verb.option("--every", "N", options->every, "Use only every N-th image of each room").positive();
  verb.option("--max-dimensions", "N", options->max_dimensions,
              "descriptors: leave out histograms with more dimensions (default 16; the thesis has "
              "at most 8)")
      .positive();
  verb.option(
      "--part", "K/N", options->part,
      "Compute only the K-th of N parts of the cells; the tables are written when all cells exist");
  addThreads(verb, options->threads);
  options->output.addTo(verb);
  verb.footer(
      "Example:\n"
      "  place_tool experiment indecs-global --data runs --out results/indecs-global");
  verb.run([options] { runExperimentVerb(*options); });
}

}  // namespace place_recognition::tool
