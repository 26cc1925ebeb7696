#pragma once

#include <CLI/CLI.hpp>

namespace place_recognition::tool {

// Each of these adds one verb with its options and, as the verb's callback, its work. The work
// throws: CLI::ParseError for bad usage, Error for bad input, Cancelled after a signal.

void addSimulate(CLI::App& tool);
void addImport(CLI::App& tool);
void addTrain(CLI::App& tool);
void addTune(CLI::App& tool);
void addRecognize(CLI::App& tool);
void addEvaluate(CLI::App& tool);
void addExperiment(CLI::App& tool);
void addReduce(CLI::App& tool);
void addFeatures(CLI::App& tool);
void addInfo(CLI::App& tool);
void addRestore(CLI::App& tool);
/// Hidden: writes doc/configuration.md.
void addDocument(CLI::App& tool);

/// All of the above.
inline void addVerbs(CLI::App& tool) {
  addSimulate(tool);
  addImport(tool);
  addTrain(tool);
  addTune(tool);
  addRecognize(tool);
  addEvaluate(tool);
  addExperiment(tool);
  addReduce(tool);
  addFeatures(tool);
  addInfo(tool);
  addRestore(tool);
  addDocument(tool);
}

}  // namespace place_recognition::tool
