#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "base/options.h"
#include "base/text.h"
#include "place_recognition/network.h"
#include "place_recognition/tuning.h"
#include "recognition/model/embeddings.h"
#include "report/text_table.h"
#include "tool/configuration.h"
#include "tool/inputs.h"
#include "tool/network_trial.h"
#include "tool/other_runs.h"
#include "tool/output.h"
#include "tool/part_option.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct TuneOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> validate;
  std::string out;
  std::string space;
  std::string cells;
  std::string part;
  bool same_light = false;
  unsigned threads = 0;
  InputOptions input;
  ConfigurationOptions configuration;
  OutputOptions output;
};

SearchSpace readSpace(const std::string& path) {
  SearchSpace space;
  if (path.empty()) return space;
  try {
    readOptions(readYamlFile(path), "", space);
    space.check();
  } catch (const Error& e) {
    throw Error(path + ": " + e.what());
  }
  return space;
}

/// Adds the cue of the preset `embedding` if its network is installed, unless `base` already has an
/// embedding.
void addInstalledNetwork(const TrainingOptions& base, SearchSpace& space) {
  if (!embeddingsOf(base).empty()) return;
  for (const CueOptions& cue : readPreset("embedding").cues) {
    const auto* embedding = std::get_if<EmbeddingOptions>(&cue.feature);
    if (embedding && std::filesystem::exists(networkPath(embedding->network))) {
      space.cues.push_back(cue);
    }
  }
  tryNetworks(space.cues);
}

std::string namesOf(const std::vector<CueOptions>& cues) {
  std::string names;
  for (const CueOptions& cue : cues) names += (names.empty() ? "" : " + ") + cue.name;
  return names;
}

std::vector<std::string> rowOf(const TuningTrial& trial) {
  return {trial.stage + ": " + namesOf(trial.cues),
          fixed(trial.c, 0),
          std::to_string(trial.images),
          fixed(trial.log_loss, 3),
          percent(trial.rate),
          percent(trial.changed_rate)};
}

/// The trials that satisfy `wanted`, as a table.
template <typename Wanted>
std::string table(const std::vector<TuningTrial>& trials, const Wanted& wanted) {
  std::vector<std::vector<std::string>> rows{
      {"tried", "C", "pictures", "log loss", "right", "changed"}};
  for (const TuningTrial& trial : trials) {
    if (wanted(trial)) rows.push_back(rowOf(trial));
  }
  return alignColumns(rows);
}

std::string asComment(const std::string& text) {
  std::istringstream lines(text);
  std::string comment;
  for (std::string line; std::getline(lines, line);) comment += "# " + line + "\n";
  return comment;
}

std::string yamlOf(const Tuning& tuning, const std::vector<std::string>& inputs) {
  std::string header = "Found by `place_tool tune` for";
  for (const std::string& input : inputs) header += " " + input;
  header += tuning.complete ? ".\n" : "; stopped before its end.\n";
  header += tuning.best.images == 0
                ? "It is what the search started from; nothing was compared with it yet.\n"
                : "Held-out images: log loss " + fixed(tuning.best.log_loss, 3) + ", " +
                      percent(tuning.best.rate) + " right, " + percent(tuning.best.changed_rate) +
                      " as the next run might show them.\n";
  header += "\nEverything that was tried:\n" +
            table(tuning.trials, [](const TuningTrial&) { return true; });
  return asComment(header) + "\n" + writeOptions(tuning.options);
}

Json jsonOf(const TuningTrial& trial) {
  Json cues = Json::array();
  for (const CueOptions& cue : trial.cues) cues.push_back({{"name", cue.name}});
  return {{"stage", trial.stage},
          {"cues", cues},
          {"c", trial.c},
          {"pictures", trial.images},
          {"log_loss", trial.log_loss},
          {"rate", trial.rate},
          {"changed_rate", trial.changed_rate}};
}

Json figures(const Tuning& tuning, const std::string& path) {
  Json trials = Json::array();
  for (const TuningTrial& trial : tuning.trials) trials.push_back(jsonOf(trial));
  return {{"configuration", path},     {"complete", tuning.complete}, {"pictures", tuning.images},
          {"seconds", tuning.seconds}, {"best", jsonOf(tuning.best)}, {"trials", trials}};
}

std::string finalTable(const Tuning& tuning) {
  return table(tuning.trials,
               [](const TuningTrial& trial) { return trial.stage.find("round") != 0; });
}

/// Number of images of the trial with the most.
std::uint64_t mostImages(const std::vector<TuningTrial>& trials) {
  std::uint64_t most = 0;
  for (const TuningTrial& trial : trials) most = std::max(most, trial.images);
  return most;
}

void printBest(const Tuning& tuning, const std::string& path, std::ostream& out) {
  out << "\nBest" << (tuning.complete ? "" : " so far") << ": " << namesOf(tuning.best.cues)
      << ", C " << tuning.best.c << "\n"
      << tuning.trials.size() << " configurations tried on at most " << mostImages(tuning.trials)
      << " of " << tuning.images << " images in " << fixed(tuning.seconds, 0)
      << " s. Configuration: " << path << " (place_tool train --config " << path << ")"
      << std::endl;
}

/// What a search goes by.
struct Task {
  TrainingOptions base;
  SearchSpace space;
  std::vector<RecordingOpener> recordings;
  std::vector<RecordingOpener> hold_out;
};

void tuneWhole(const TuneOptions& options, const Task& task) {
  ProgressDisplay display(options.output.progress);
  const Tuning tuning =
      place_recognition::tune(task.recordings, task.hold_out, task.base, task.space,
                              options.threads, display.callback(), options.cells);
  display.clear();

  if (!tuning.complete && tuning.trials.empty()) throw Cancelled();
  options.output.text() << finalTable(tuning) << std::flush;  // also if the file cannot be written
  writeText(options.out, yamlOf(tuning, options.inputs));
  printBest(tuning, options.out, options.output.text());
  options.output.writeJson(figures(tuning, options.out));
  if (!tuning.complete) throw Cancelled();
}

void tuneInPart(const TuneOptions& options, const Task& task, const Part& part) {
  ProgressDisplay display(options.output.progress);
  const TuningPart result = tunePart(task.recordings, task.hold_out, task.base, task.space,
                                     options.cells, part, options.threads, display.callback());
  display.clear();
  options.output.text() << result.cells << " cells, " << result.computed
                        << " computed now: " << options.cells << std::endl;
  options.output.writeJson({{"cells", result.cells}, {"computed", result.computed}});
}

void tune(const TuneOptions& options) {
  const std::optional<Part> part =
      options.part.empty() ? std::nullopt : std::make_optional(parsePart(options.part));
  Task task{options.configuration.read(), readSpace(options.space), {}, {}};
  if (options.same_light) task.space.other_light = false;
  addInstalledNetwork(task.base, task.space);
  requireWritable(options.out, Contents::kText);
  requireOtherRuns(options.validate, options.inputs);
  task.recordings = options.input.openers(options.inputs, options.validate.empty());
  if (!options.validate.empty())
    task.hold_out = options.input.withoutLabels().openers(options.validate, false);
  std::optional<NewFolder> cells;
  if (!options.cells.empty()) cells.emplace(options.cells);
  if (part) {
    tuneInPart(options, task, *part);
  } else {
    tuneWhole(options, task);
  }
}

}  // namespace

void addTune(CommandLine& tool) {
  Verb& verb = tool.verb("tune", "Finds features and C by cross-validation over runs");
  const auto options = std::make_shared<TuneOptions>();
  verb.argument("INPUT", options->inputs, kInputHelp);
  verb.option("--out", "FILE.yaml", options->out, "YAML file for `train --config`")
      .required()
      .written();
  verb.option("--validate", "INPUT", options->validate,
              "Runs to test on instead of cross-validation within INPUT")
      .many();
  verb.option("--space", "FILE", options->space,
              "YAML file of the search space; see doc/configuration.md");
  verb.flag("--same-light", options->same_light,
            "The light never differs from that of these runs: do not vary it in the held-out "
            "images that represent the next run");
  verb.option("--cells", "DIR", options->cells,
              "Folder for what is found out about each set of descriptors: an interrupted search "
              "continues where it stopped");
  verb.option("--part", "K/N", options->part,
              "Compute only the K-th of N parts of the cells, at most one part for each set of "
              "descriptors, and write no configuration. Without --part, the same command then "
              "writes it")
      .needs("--cells");
  options->configuration.addTo(verb);
  options->input.addTo(verb);
  addThreads(verb, options->threads);
  options->output.addTo(verb);
  verb.footer(
      "Starts from the default configuration, or that of --config, and leaves it only if held-out\n"
      "images, unchanged and as the next run might show them, clearly favour another. One or two\n"
      "rounds find the best scales and bins on few images (--space: first_pictures); cues and C "
      "are\n"
      "then chosen on more images (max_pictures). Ctrl-C keeps the best configuration so far.\n"
      "Example:\n"
      "  place_tool tune monday.bag tuesday.bag --out office.yaml\n"
      "  place_tool train monday.bag tuesday.bag --model office --config office.yaml");
  verb.run([options] { tune(*options); });
}

}  // namespace place_recognition::tool
