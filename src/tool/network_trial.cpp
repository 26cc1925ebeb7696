#include "tool/network_trial.h"

#include <chrono>
#include <iostream>
#include <memory>
#include <opencv2/core/version.hpp>
#include <vector>

#include "base/child_process.h"
#include "base/data_folder.h"
#include "base/options.h"
#include "base/process_limits.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/progress.h"
#include "recognition/model/embeddings.h"
#include "tool/output.h"
#include "tool/signals.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

constexpr unsigned kMaxSeconds = 60;  // processor time

struct TryOptions {
  std::string name;
  std::string layer;
  std::string yaml;
};

std::string toText(const NetworkFacts& facts) {
  return jsonLine({{"bytes", facts.bytes},
                   {"sha256", facts.sha256},
                   {"channels", facts.channels},
                   {"width", facts.width},
                   {"height", facts.height},
                   {"layers", facts.layers},
                   {"dimension", facts.dimension}});
}

NetworkFacts toFacts(const std::string& text) {
  const Json json = Json::parse(text);
  return {json.at("bytes"),  json.at("sha256"), json.at("channels"), json.at("width"),
          json.at("height"), json.at("layers"), json.at("dimension")};
}

/// The work of the child process.
void tryHere(const TryOptions& options) {
  limitProcess(kMaxSeconds);
  if (options.yaml.empty()) {
    std::cout << toText(networkFacts(options.name, options.layer));
    return;
  }
  EmbeddingOptions embedding;
  readOptions(parseYaml(options.yaml, "the options of the embedding"), "", embedding);
  loadNetwork(embedding);
}

/// Returns what another place_tool prints for `network try` with these arguments. `name` and
/// `layer` are for messages.
std::string runTrial(const std::vector<std::string>& arguments, const std::string& name,
                     const std::string& layer) {
  std::vector<std::string> command{findExecutable("place_tool"), "network", "try"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  ChildProcess trial(command, ChildProcess::Stderr::kPipe);
  std::string output;
  std::string complaint;
  while (trial.readLines(
      std::chrono::seconds(1), [&](const std::string& line) { output += line; },
      [&](const std::string& line) { complaint = line; })) {
    if (stopRequested()) throw Cancelled();
  }
  const int status = trial.wait();
  if (status == 0) return output;
  if (stopRequested()) throw Cancelled();  // Ctrl-C ends the trial, too
  requireStarted("place_tool", status);
  const std::string own_name = "place_tool network try: ";
  if (startsWith(complaint, own_name)) {
    throw Error(complaint.substr(own_name.size()));
  }
  throw Error("The network " + networkPath(name) + " cannot be used (" +
              (layer.empty() ? "its output" : "layer " + inQuotes(layer)) +
              ", OpenCV " CV_VERSION "): the process that tried it ended with " +
              describeExit(status) + "; doc/networks.md lists networks that can.");
}

}  // namespace

void tryNetworks(const std::vector<CueOptions>& cues) {
  for (const CueOptions& cue : cues) {
    const auto* embedding = std::get_if<EmbeddingOptions>(&cue.feature);
    if (!embedding || embedding->loaded) continue;
    runTrial({"--options=" + writeOptions(*embedding), "--", embedding->network},
             embedding->network, embedding->layer);
  }
}

NetworkFacts tryNetwork(const std::string& name, const std::string& layer) {
  std::vector<std::string> arguments{"--", name};
  if (!layer.empty()) arguments.insert(arguments.begin(), "--layer=" + layer);
  return toFacts(runTrial(arguments, name, layer));
}

void addNetworkTry(CommandLine& tool) {
  Verb& verb = tool.verb("network try", "Reads a network and runs it once, within limits");
  const auto options = std::make_shared<TryOptions>();
  verb.argument("NAME", options->name, "Name or file of the network");
  verb.option("--layer", "NAME", options->layer, "Layer to use");
  verb.option("--options", "YAML", options->yaml, "All options of a feature of type embedding")
      .excludes("--layer");
  verb.footer("Example:\n  place_tool network try mobilenet");
  verb.hide();
  verb.run([options] { tryHere(*options); });
}

}  // namespace place_recognition::tool
