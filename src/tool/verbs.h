#pragma once

#include "tool/command_line.h"

namespace place_recognition::tool {

// Each of these adds one verb with its options and its work.

void addSimulate(CommandLine& tool);
void addImport(CommandLine& tool);
void addLabel(CommandLine& tool);
void addTrain(CommandLine& tool);
void addTune(CommandLine& tool);
void addCalibrate(CommandLine& tool);
void addRecognize(CommandLine& tool);
void addEvaluate(CommandLine& tool);
void addExperiment(CommandLine& tool);
void addReduce(CommandLine& tool);
void addFeatures(CommandLine& tool);
void addInfo(CommandLine& tool);
void addRestore(CommandLine& tool);
void addNetworkAdd(CommandLine& tool);
void addNetworkList(CommandLine& tool);
/// Hidden: the child process of tryNetworks().
void addNetworkTry(CommandLine& tool);
/// Hidden: writes doc/configuration.md.
void addDocument(CommandLine& tool);

/// All of the above.
inline void addVerbs(CommandLine& tool) {
  addSimulate(tool);
  addImport(tool);
  addLabel(tool);
  addTrain(tool);
  addTune(tool);
  addCalibrate(tool);
  addRecognize(tool);
  addEvaluate(tool);
  addExperiment(tool);
  addReduce(tool);
  addFeatures(tool);
  addInfo(tool);
  addRestore(tool);
  addNetworkAdd(tool);
  addNetworkList(tool);
  addNetworkTry(tool);
  addDocument(tool);
}

}  // namespace place_recognition::tool
