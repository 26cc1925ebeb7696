#include "place_recognition/network.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/core/version.hpp>

#include "base/atomic_file.h"
#include "base/data_folder.h"
#include "base/require.h"
#include "base/sha256.h"
#include "base/text.h"
#include "features/network_runner.h"
#include "features/onnx_graph.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".onnx";
constexpr int kMinSide = 16;
constexpr int kMaxSide = 1024;
constexpr int kMaxStride = 64;
constexpr int kMaxColumns = 16;
constexpr int kMaxPower = 8;
constexpr int kUsualSide = 224;  // default for networks that do not fix it
constexpr int kUsualChannels = 3;

bool isSide(int side) { return side == 0 || (side >= kMinSide && side <= kMaxSide); }

/// The size in the options, else the declared one.
int chooseSide(const char* key, int declared, int wanted) {
  const int side = wanted > 0 ? wanted : declared;
  require(side > 0, "it does not fix the size of its input; give 'width' and 'height'");
  require(isSide(side), "the " + std::string(key) + " of its input is " + std::to_string(side) +
                            " pixels; 16 to 1024 are supported");
  return side;
}

/// The input shape from the options and the declaration; all intermediate shapes depend on it.
NetworkInput chooseInput(const NetworkInput& declared, const EmbeddingOptions& options) {
  const int channels = options.channels == "grey" ? 1 : 3;
  require(declared.channels == 0 || declared.channels == channels,
          "it takes images with " + std::to_string(declared.channels) +
              " channels, but the option is 'channels: " + options.channels + "'");
  return {channels, chooseSide("height", declared.height, options.height),
          chooseSide("width", declared.width, options.width)};
}

std::string readNetwork(const std::string& name) {
  const std::string path = networkPath(name);
  std::error_code ignored;
  if (!isFileName(name, kExtension) && !fs::exists(path, ignored)) {
    throw Error("There is no network '" + name + "' in " + networkFolder() +
                "; install one: place_tool network add FILE --name " + name +
                " (doc/networks.md lists some).");
  }
  return readFile(path, kMaxNetworkBytes);
}

/// Calls `work()`; errors get the network, the layer and OpenCV's version in front.
template <typename Work>
auto explained(const std::string& name, const std::string& layer, const Work& work) {
  try {
    return work();
  } catch (const Error& e) {
    throw Error("The network " + networkPath(name) + " cannot be used (" +
                (layer.empty() ? "its output" : "layer " + inQuotes(layer)) +
                ", OpenCV " CV_VERSION "): " + e.what() +
                "; doc/networks.md lists networks that can.");
  }
}

}  // namespace

void EmbeddingOptions::check(const std::string& key) const {
  requireSome(network, key + ".network", "the name of a network or a file");
  requireOption(isFileName(network, kExtension) || isPlainName(network), key + ".network", network,
                "a name of letters, digits, '_' and '-', or a file that ends in .onnx");
  requireOption(isSide(width), key + ".width", width, "16 to 1024 pixels, or 0");
  requireOption(isSide(height), key + ".height", height, "16 to 1024 pixels, or 0");
  requireOption(stride == 0 || (stride > 1 && stride <= kMaxStride && (stride & (stride - 1)) == 0),
                key + ".stride", stride, "2, 4, 8, 16, 32, 64, or 0");
  requireOption(columns >= 1 && columns <= kMaxColumns, key + ".columns", columns, "1 to 16");
  requireOption(power >= 1 && power <= kMaxPower, key + ".power", power, "1 to 8");
  requireOption(fit == "stretch" || fit == "crop", key + ".fit", fit, "stretch or crop");
  requireOption(channels == "rgb" || channels == "bgr" || channels == "grey", key + ".channels",
                channels, "rgb, bgr or grey");
  for (const std::vector<double>* numbers : {&mean, &scale}) {
    const std::string list = key + (numbers == &mean ? ".mean" : ".scale");
    require(numbers->size() == 1 || (numbers->size() == 3 && channels != "grey"),
            "Option '" + list + "' has " + std::to_string(numbers->size()) +
                " numbers; give one, or one for each channel.");
    for (const double x : *numbers) {
      requireOption(std::abs(x) <= 1000 && (numbers == &mean || x != 0), list, x,
                    numbers == &mean ? "-1000 to 1000" : "-1000 to 1000, but not 0");
    }
  }
}

void loadNetwork(EmbeddingOptions& options) {
  options.check();
  const std::string file = readNetwork(options.network);
  explained(options.network, options.layer, [&] {
    OnnxGraph graph(file);
    graph.cutBehind(options.layer);
    graph.cutBeforePooling();
    graph.setInput(chooseInput(graph.input(), options));
    const NetworkRunner runner(graph, {options.stride});
    const int width = runner.width(0);
    require(width >= options.columns,
            "its output is " + std::to_string(width) + " wide, too narrow for 'columns: " +
                std::to_string(options.columns) + "'; name an earlier layer");
    options.dimension = runner.dimension(0);
    options.loaded = std::make_shared<const Network>(Network{graph.bytes(), sha256(file)});
  });
}

NetworkFacts networkFacts(const std::string& name, const std::string& layer) {
  const std::string file = readNetwork(name);
  return explained(name, layer, [&] {
    OnnxGraph graph(file);
    graph.cutBehind(layer);
    const NetworkInput declared = graph.input();
    const auto or_else = [](int value, int usual) { return value > 0 ? value : usual; };
    graph.setInput({or_else(declared.channels, kUsualChannels),
                    or_else(declared.height, kUsualSide), or_else(declared.width, kUsualSide)});
    const NetworkRunner runner(graph, {0});
    return NetworkFacts{file.size(),     sha256(file),   declared.channels,  declared.width,
                        declared.height, graph.layers(), runner.dimension(0)};
  });
}

std::vector<std::string> networkNames() {
  std::vector<std::string> names;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(networkFolder(), failure)) {
    const fs::path& path = entry.path();
    if (path.extension() == kExtension && isPlainName(path.stem().string())) {
      names.push_back(path.stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string networkFolder() { return dataFolder("networks"); }

std::string networkPath(const std::string& name) {
  if (isFileName(name, kExtension)) return name;
  if (!isPlainName(name)) {
    throw Error(inQuotes(name) + " cannot name a network; use " + kPlainNameRule + ".");
  }
  return networkFolder() + "/" + name + kExtension;
}

}  // namespace place_recognition
