#include "tool/configuration.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/options.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "tool/network_trial.h"
#include "tool/package_folder.h"

namespace place_recognition::tool {
namespace {

namespace fs = std::filesystem;

std::string configurationPath(const std::string& config) {
  const bool is_name = config.find_first_of("/.") == std::string::npos;
  if (!is_name || fs::exists(config)) return config;
  const fs::path preset = fs::path(packageFolder("config")) / (config + ".yaml");
  if (fs::exists(preset)) return preset.string();
  throw Error("There is no configuration '" + config +
              "'; give a YAML file or a preset: " + listed(presetNames()) + ".");
}

/// Calls `work()`; puts `where` in front of the message of an Error.
template <typename Work>
void explain(const std::string& where, const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    throw Error(where + ": " + e.what());
  }
}

void readOptionsFile(const std::string& path, TrainingOptions& options) {
  const YAML::Node file = readYamlFile(path);
  explain(path, [&] {
    readOptions(file, "", options);
    options.check();
  });
}

}  // namespace

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  std::error_code failure;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(packageFolder("config"), failure)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TrainingOptions readPreset(const std::string& name) {
  TrainingOptions options;
  readOptionsFile(configurationPath(name), options);
  return options;
}

void ConfigurationOptions::addTo(Verb& verb, const TrainingOptions& defaults) {
  verb.option("--config", "FILE", config,
              "YAML file, or the name of a preset, such as crfh_colour");
  verb.option("--set", "KEY=VALUE", set,
              "Set one option, for example svm.c=10 or cues." + defaults.cues.front().name +
                  ".kernel.gamma=30; see doc/configuration.md. May be repeated");
}

TrainingOptions ConfigurationOptions::read(TrainingOptions options) const {
  if (!config.empty()) readOptionsFile(configurationPath(config), options);
  if (!set.empty()) {
    const YAML::Node tree = parseYaml(writeOptions(options), "the configuration");
    std::set<std::string> keys;
    for (const std::string& assignment : set) {
      const std::string key = assignment.substr(0, assignment.find('='));
      if (!keys.insert(key).second) throw UsageError("--set: " + key + " is given twice");
      assignOption(tree, assignment);
    }
    explain("--set", [&] {
      readOptions(tree, "", options);
      options.check();
    });
  }
  tryNetworks(options.cues);
  return options;
}

}  // namespace place_recognition::tool
