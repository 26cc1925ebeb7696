#pragma once

#include <string>
#include <vector>

#include "place_recognition/network.h"
#include "place_recognition/training_options.h"

namespace place_recognition::tool {

// ONNX files may come from anywhere, and OpenCV's reader is not designed for hostile ones. Before
// this program uses a file, a separate process, `place_tool network try`, reads it and runs it
// once, with at most 4 GiB of memory and 60 s of processor time, as for bags.

/// Tries the networks that `cues` name. Throws Error, one line that names the file, the layer and
/// OpenCV's version, for the first one that cannot be used.
void tryNetworks(const std::vector<CueOptions>& cues);

/// Tries the network `name` (see networkPath()) as networkFacts() does, and returns the result.
/// Throws Error likewise.
NetworkFacts tryNetwork(const std::string& name, const std::string& layer);

}  // namespace place_recognition::tool
