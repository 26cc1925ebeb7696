#pragma once

#include <string>
#include <vector>

#include "place_recognition/training_options.h"
#include "tool/verb.h"

namespace place_recognition::tool {

/// `--config` and `--set` of the verbs that take training options.
struct ConfigurationOptions {
  std::string config;            ///< a YAML file, or the name of a preset; empty: the defaults
  std::vector<std::string> set;  ///< key=value, applied in order after the file

  /// `defaults`: what read() will be given; the help names one of its cues.
  void addTo(Verb& verb, const TrainingOptions& defaults = TrainingOptions());

  /// `options`, overwritten by the file and then by the assignments; checked. A list in the file,
  /// such as cues, replaces that of `options`. Tries the networks that the result names
  /// (network_trial.h). Throws Error naming the file and the key.
  TrainingOptions read(TrainingOptions options = TrainingOptions()) const;
};

/// A preset of the package. Networks that it names are not tried.
TrainingOptions readPreset(const std::string& name);

/// Names of the package's presets, in ascending order: `crfh` for `config/crfh.yaml`.
std::vector<std::string> presetNames();

}  // namespace place_recognition::tool
