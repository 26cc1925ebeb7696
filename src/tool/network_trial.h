#pragma once

#include <string>
#include <vector>

#include "place_recognition/network.h"
#include "place_recognition/training_options.h"

namespace place_recognition::tool {

// An ONNX file may come from anywhere, and OpenCV's reader is not made for hostile ones. Before
// this program uses one, another process, `place_tool network try`, reads it and runs it once,
// with at most 4 GiB of memory and 60 s of processor time, as bags are read.

/// Tries the networks that `cues` name. Throws Error, one line that names the file, the layer
/// and OpenCV's version, for the first that cannot be used.
void tryNetworks(const std::vector<CueOptions>& cues);

/// Tries the network `name` (see networkPath()) as networkFacts() does, and returns what that
/// finds. Throws Error likewise.
NetworkFacts tryNetwork(const std::string& name, const std::string& layer);

}  // namespace place_recognition::tool
