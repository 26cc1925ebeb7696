#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include "base/atomic_file.h"
#include "base/options.h"
#include "place_recognition/tuning.h"
#include "report/text_table.h"
#include "tool/configuration.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct TuneOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> validate;
  std::string out;
  std::string space;
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

/// What everything else is taken from. Its cues are tried only if a configuration was named.
TrainingOptions readBase(const ConfigurationOptions& configuration) {
  TrainingOptions base = configuration.read();
  if (configuration.config.empty()) base.cues.clear();
  return base;
}

std::string namesOf(const std::vector<CueOptions>& cues) {
  std::string names;
  for (const CueOptions& cue : cues) names += (names.empty() ? "" : " + ") + cue.name;
  return names;
}

std::string gammasOf(const std::vector<CueOptions>& cues) {
  std::ostringstream text;
  text.precision(3);
  for (const CueOptions& cue : cues) text << (&cue == &cues[0] ? "" : " ") << cue.kernel.gamma;
  return text.str();
}

std::vector<std::string> rowOf(const TuningTrial& trial) {
  return {trial.stage + ": " + namesOf(trial.cues), gammasOf(trial.cues),     fixed(trial.c, 0),
          std::to_string(trial.pictures),           fixed(trial.log_loss, 3), percent(trial.rate),
          percent(trial.other_light_rate)};
}

/// The trials as a table, those for which `wanted` holds.
template <typename Wanted>
std::string table(const std::vector<TuningTrial>& trials, const Wanted& wanted) {
  std::vector<std::vector<std::string>> rows{
      {"tried", "gamma", "C", "pictures", "log loss", "right", "in other light"}};
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
  header += "Held-out pictures: log loss " + fixed(tuning.best.log_loss, 3) + ", " +
            percent(tuning.best.rate) + " right, " + percent(tuning.best.other_light_rate) +
            " in other light.\n\nEverything that was tried:\n" +
            table(tuning.trials, [](const TuningTrial&) { return true; });
  return asComment(header) + "\n" + writeOptions(tuning.options);
}

Json jsonOf(const TuningTrial& trial) {
  Json cues = Json::array();
  for (const CueOptions& cue : trial.cues) {
    cues.push_back({{"name", cue.name}, {"gamma", cue.kernel.gamma}});
  }
  return {{"stage", trial.stage},
          {"cues", cues},
          {"c", trial.c},
          {"pictures", trial.pictures},
          {"log_loss", trial.log_loss},
          {"rate", trial.rate},
          {"other_light_rate", trial.other_light_rate}};
}

Json figures(const Tuning& tuning, const std::string& path) {
  Json trials = Json::array();
  for (const TuningTrial& trial : tuning.trials) trials.push_back(jsonOf(trial));
  return {{"configuration", path},     {"complete", tuning.complete}, {"pictures", tuning.pictures},
          {"seconds", tuning.seconds}, {"best", jsonOf(tuning.best)}, {"trials", trials}};
}

void printSummary(const Tuning& tuning, const std::string& path, std::ostream& out) {
  out << table(tuning.trials,
               [](const TuningTrial& trial) { return trial.stage.find("round") != 0; })
      << "\nBest" << (tuning.complete ? "" : " so far") << ": " << namesOf(tuning.best.cues)
      << ", C " << tuning.best.c << "\n"
      << tuning.trials.size() << " configurations tried on " << tuning.pictures << " pictures in "
      << fixed(tuning.seconds, 0) << " s. Configuration: " << path << " (place_tool train --config "
      << path << ")" << std::endl;
}

void tune(const TuneOptions& options) {
  SearchSpace space = readSpace(options.space);
  if (options.same_light) space.other_light = false;
  const TrainingOptions base = readBase(options.configuration);
  requireWritable(options.out);
  const std::vector<RunOpener> runs = options.input.openers(options.inputs);
  const std::vector<RunOpener> hold_out =
      options.validate.empty() ? std::vector<RunOpener>() : options.input.openers(options.validate);

  ProgressDisplay display(options.output.progress);
  const Tuning tuning =
      place_recognition::tune(runs, hold_out, base, space, options.threads, display.callback());
  writeFileAtomically(options.out, yamlOf(tuning, options.inputs));
  display.clear();

  printSummary(tuning, options.out, options.output.text());
  options.output.writeJson(figures(tuning, options.out));
  if (!tuning.complete) throw Cancelled();
}

}  // namespace

void addTune(CommandLine& tool) {
  Verb& verb = tool.verb("tune", "Finds features, gamma and C by cross-validation over runs");
  const auto options = std::make_shared<TuneOptions>();
  verb.argument("INPUT", options->inputs, kInputHelp);
  verb.option("--out", "FILE.yaml", options->out, "YAML file for `train --config`").required();
  verb.option("--validate", "INPUT", options->validate,
              "Runs to test on instead of cross-validation within INPUT")
      .many();
  verb.option("--space", "FILE", options->space,
              "YAML file that says what to try; see doc/configuration.md");
  verb.flag("--same-light", options->same_light,
            "The rooms will only be seen in the light of these runs: do not judge the held-out "
            "pictures in other light, too");
  options->configuration.addTo(verb);
  options->input.addTo(verb);
  verb.option("--threads", "N", options->threads, "Threads; 0: one a core. Changes no result");
  options->output.addTo(verb);
  verb.footer(
      "Two rounds compare scales and bins on few pictures (--space: first_pictures), then gamma,\n"
      "the combination of cues and C are chosen on more of them (max_pictures).\n"
      "Cues of --config are tried beside those of the search space. Ctrl-C keeps the best so far.\n"
      "Example:\n"
      "  place_tool tune monday.bag tuesday.bag --out office.yaml\n"
      "  place_tool train monday.bag tuesday.bag --model office --config office.yaml");
  verb.run([options] { tune(*options); });
}

}  // namespace place_recognition::tool
