#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

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

using Sets = std::vector<ImageSet>;

/// What an experiment is computed from.
enum class Data { kNone, kConditions, kBuildings, kMaterials };

/// An experiment, as users name it. The help texts together are that of the argument NAME.
struct ExperimentKind {
  const char* name;
  Data data;
  std::unique_ptr<Experiment> (*make)(Sets sets, const ExperimentOptions& options);
  const char* help;
};

const ExperimentKind kExperiments[] = {
    {"indecs-local", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return finalExperiment(PlaceFeatures::kLocal, std::move(sets), options.threads);
     },
     "Table 8.2"},
    {"indecs-global", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return finalExperiment(PlaceFeatures::kGlobal, std::move(sets), options.threads);
     },
     "Table 8.6"},
    {"descriptors", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return descriptorsExperiment(std::move(sets), options.max_dimensions, options.threads);
     },
     "Table 8.4"},
    {"bins", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return binsExperiment(std::move(sets), options.threads);
     },
     "Table 8.5"},
    {"reduction", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return reductionExperiment(std::move(sets), options.threads);
     },
     "Tables 8.3, 8.7"},
    {"materials", Data::kMaterials,
     [](Sets sets, const ExperimentOptions& options) {
       return materialsExperiment(std::move(sets), options.threads);
     },
     "Tables 7.1 to 7.6"},
    {"figures", Data::kNone, [](Sets, const ExperimentOptions&) { return figuresExperiment(); },
     "Figures 5.5, 6.1, 6.2, without --data"},
    {"learning-curve", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return learningCurveExperiment(std::move(sets), options.threads);
     },
     "number of images and viewpoints needed"},
    {"categories", Data::kBuildings,
     [](Sets sets, const ExperimentOptions& options) {
       return categoriesExperiment(std::move(sets), options.threads);
     },
     "rooms of a building outside the training set"},
    {"cues", Data::kConditions,
     [](Sets sets, const ExperimentOptions& options) {
       return cuesExperiment(std::move(sets), options.threads);
     },
     "ways of combining several"}};

std::vector<std::string> experimentNames() {
  std::vector<std::string> names;
  for (const ExperimentKind& kind : kExperiments) names.push_back(kind.name);
  return names;
}

std::string experimentHelp() {
  std::string help;
  for (const ExperimentKind& kind : kExperiments) {
    help += (help.empty() ? "" : "; ") + std::string(kind.name) + ": " + kind.help;
  }
  return help;
}

const ExperimentKind& kindOf(const ExperimentOptions& options) {
  return *std::find_if(std::begin(kExperiments), std::end(kExperiments),
                       [&](const ExperimentKind& kind) { return options.name == kind.name; });
}

/// Throws UsageError for an option that this experiment does not have, and for a missing one.
void requireApplicable(const ExperimentOptions& options) {
  const ExperimentOptions defaults;
  const Data data = kindOf(options).data;
  if (options.layout != defaults.layout && (data == Data::kNone || data == Data::kMaterials)) {
    throw UsageError("--layout applies to images of places");
  }
  if (options.every != defaults.every && data == Data::kNone) {
    throw UsageError("--every requires --data");
  }
  if (options.max_dimensions != defaults.max_dimensions && options.name != "descriptors") {
    throw UsageError("--max-dimensions applies to descriptors");
  }
  if (data == Data::kNone && !options.data.empty()) {
    throw UsageError("--data: the figures use artificial points; omit it");
  }
  if (data != Data::kNone && options.data.empty()) throw UsageError("--data is required");
}

/// Warns of folders without images.
Sets setsOf(const ExperimentOptions& options) {
  const Data data = kindOf(options).data;
  if (data == Data::kNone) return {};
  if (data == Data::kMaterials) return sampleSets(options.data);
  std::vector<std::string> warnings;
  Sets sets = data == Data::kBuildings ? buildingSets(options.data, options.layout, warnings)
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
  Sets sets = setsOf(options);
  const NewFolder folder(options.out);
  ProgressDisplay display(options.output.progress);
  std::size_t images = 0, unusable = 0;
  for (ImageSet& set : sets) {
    set = thinnedOut(set, options.every);
    unusable += leaveOutUnusable(set, options.threads, display);
    images += set.images.size();
  }
  const std::string digest = digestOf(sets);
  const std::unique_ptr<Experiment> experiment = kindOf(options).make(std::move(sets), options);
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
  verb.argument("NAME", options->name, experimentHelp()).oneOf(experimentNames());
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
