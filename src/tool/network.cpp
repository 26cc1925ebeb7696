#include <strings.h>

#include <iostream>
#include <memory>

#include "base/atomic_file.h"
#include "base/data_folder.h"
#include "base/sha256.h"
#include "base/temporary_file.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "tool/download.h"
#include "tool/network_trial.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct NetworkAddOptions {
  std::string source;
  std::string name;
  std::string layer;
  std::string sha256;
  OutputOptions output;
};

Json figures(const std::string& name, const NetworkFacts& facts) {
  return {{"network", name},        {"file", networkPath(name)},  {"bytes", facts.bytes},
          {"sha256", facts.sha256}, {"channels", facts.channels}, {"width", facts.width},
          {"height", facts.height}, {"layers", facts.layers},     {"dimension", facts.dimension}};
}

/// The entry of a network in the list; a file that cannot be used must not prevent listing the
/// others.
Json describe(const std::string& name) {
  try {
    return figures(name, tryNetwork(name, ""));
  } catch (const Error& e) {
    return {{"network", name}, {"file", networkPath(name)}, {"problem", e.what()}};
  }
}

/// 0: not fixed.
std::string inputText(int width, int height) {
  return width > 0 && height > 0 ? "images of " + sizeText(width, height) : "images of any size";
}

void print(const Json& network, std::ostream& out) {
  out << network["network"].get<std::string>() << ": ";
  if (network.contains("problem")) {
    out << network["problem"].get<std::string>() << std::endl;
    return;
  }
  out << network["bytes"] << " bytes, " << network["layers"] << " layers, "
      << inputText(network["width"], network["height"]) << " in, " << network["dimension"]
      << " values out\n"
      << "  SHA-256 " << network["sha256"].get<std::string>() << std::endl;
}

void requireSha256(const std::string& bytes, const NetworkAddOptions& options) {
  if (options.sha256.empty()) return;
  const std::string found = sha256(bytes);
  if (strcasecmp(found.c_str(), options.sha256.c_str()) == 0) return;
  throw Error("The SHA-256 of " + options.source + " is " + found + ", not " + options.sha256 +
              "; it is not the intended network and was not installed.");
}

/// Tries the network under its staged name, without showing that name in messages.
NetworkFacts tryStaged(const TemporaryFile& staged, const NetworkAddOptions& options) {
  try {
    return tryNetwork(staged.path(), options.layer);
  } catch (const Error& e) {
    std::string message = e.what();
    const std::size_t at = message.find(staged.path());
    if (at != std::string::npos) message.replace(at, staged.path().size(), options.source);
    throw Error(message);
  }
}

void add(const NetworkAddOptions& options) {
  if (!isPlainName(options.name)) {
    throw UsageError(std::string("--name takes ") + kPlainNameRule);
  }
  const std::string bytes =
      isUrl(options.source) ? download(options.source, kMaxNetworkBytes, options.output.progress)
                            : readFile(options.source, kMaxNetworkBytes);
  requireSha256(bytes, options);
  const std::string target = networkPath(options.name);
  const NewFolder folder(networkFolder());
  TemporaryFile staged(networkFolder() + "/." + options.name + ".new-", ".onnx", target);
  staged.write(bytes);
  const Json network = figures(options.name, tryStaged(staged, options));
  staged.rename(target);
  print(network, options.output.text());
  options.output.writeJson(network);
}

void list(const OutputOptions& output) {
  Json networks = Json::array();
  for (const std::string& name : networkNames()) networks.push_back(describe(name));
  if (networks.empty()) {
    output.text() << "There is no network in " << networkFolder()
                  << "; see place_tool network add --help." << std::endl;
  }
  for (const Json& network : networks) print(network, output.text());
  output.writeJson({{"networks", networks}});
}

}  // namespace

void addNetworkAdd(CommandLine& tool) {
  Verb& verb = tool.verb("network add", "Installs a network for the cue `embedding`");
  const auto options = std::make_shared<NetworkAddOptions>();
  verb.argument("SOURCE", options->source,
                "ONNX file, or a URL (https, http, ftp), downloaded with curl");
  verb.option("--name", "NAME", options->name,
              "Name for use in configurations; `mobilenet` in the presets")
      .required();
  verb.option("--sha256", "HEX", options->sha256, "Refuse a file with a different SHA-256");
  verb.option("--layer", "NAME", options->layer,
              "Layer to use, required if the network has several outputs; the whole file is "
              "installed in any case");
  options->output.addTo(verb);
  verb.footer(
      "Networks are installed in $ROS_HOME/place_recognition/networks; doc/networks.md lists "
      "some.\n"
      "Example:\n"
      "  place_tool network add mobilenet_v1_1.0_224.onnx --name mobilenet");
  verb.run([options] { add(*options); });
}

void addNetworkList(CommandLine& tool) {
  Verb& verb = tool.verb("network list", "Lists the installed networks");
  const auto output = std::make_shared<OutputOptions>();
  output->addTo(verb);
  verb.footer("Example:\n  place_tool network list");
  verb.run([output] { list(*output); });
}

}  // namespace place_recognition::tool
