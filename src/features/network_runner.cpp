#include "features/network_runner.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

#include "base/require.h"
#include "place_recognition/network.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;   // of all data between layers
constexpr std::int64_t kMaxOperations = 100'000'000'000;  // on one image

std::vector<int> shapeOf(const NetworkInput& input) {
  return {1, input.channels, input.height, input.width};
}

cv::dnn::Net read(const std::string& onnx) {
  cv::dnn::Net net = cv::dnn::readNetFromONNX(onnx.data(), onnx.size());
  net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
  return net;
}

/// Called before anything is allocated.
void checkCosts(const cv::dnn::Net& net, const NetworkInput& input) {
  std::size_t weights = 0;
  std::size_t blobs = 0;
  net.getMemoryConsumption(shapeOf(input), weights, blobs);
  require(blobs <= kMaxBytes, "it needs more than 1 GiB of memory per image");
  require(net.getFLOPS(shapeOf(input)) <= kMaxOperations,
          "it needs more than 100 billion operations per image");
}

cv::Mat greyImage(const NetworkInput& input) {
  return cv::Mat(shapeOf(input), CV_32F, cv::Scalar(0.1));
}

/// The power of two that is nearest to side / output. Layers without padding make the ratio uneven.
int strideOf(int side, int output) {
  return 1 << std::max(0L, std::lround(std::log2(static_cast<double>(side) / output)));
}

/// The last layer of each stride above 1 (see EmbeddingOptions) that is the same in height and
/// width. The names are OpenCV's, which differ from version to version, so no file contains them.
std::map<int, cv::String> layersByStride(cv::dnn::Net& net, const NetworkInput& input) {
  std::vector<int> ids;
  std::vector<std::vector<cv::dnn::MatShape>> inputs;
  std::vector<std::vector<cv::dnn::MatShape>> outputs;
  net.getLayersShapes(shapeOf(input), ids, inputs, outputs);
  std::map<int, cv::String> layers;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] == 0 || outputs[i].empty() || outputs[i][0].size() != 4) continue;
    const int height = outputs[i][0][2];
    const int width = outputs[i][0][3];
    if (height < 1 || width < 1) continue;
    const int stride = strideOf(input.width, width);
    if (stride > 1 && stride == strideOf(input.height, height)) {
      layers[stride] = net.getLayer(ids[i])->name;
    }
  }
  return layers;
}

/// The names of the layers with these strides; that of the last layer for 0.
std::vector<cv::String> layersOf(const std::vector<int>& strides, cv::dnn::Net& net,
                                 const NetworkInput& input) {
  const std::map<int, cv::String> layers = layersByStride(net, input);
  std::string available;
  for (const auto& layer : layers) {
    available += (available.empty() ? "" : ", ") + std::to_string(layer.first);
  }
  std::vector<cv::String> names;
  for (const int stride : strides) {
    require(stride == 0 || layers.count(stride) > 0,
            "it has no layer with 'stride: " + std::to_string(stride) + "'; it has strides of " +
                (available.empty() ? "1 only" : available));
    names.push_back(stride == 0 ? net.getLayerNames().back() : layers.at(stride));
  }
  return names;
}

/// The message of an exception without paths of sources, on one line. An error within a layer is at
/// its end, such as "... error: (-5:Bad argument) WHAT in function 'f'".
std::string reasonOf(const std::exception& e) {
  const auto* of_opencv = dynamic_cast<const cv::Exception*>(&e);
  std::string text = of_opencv ? of_opencv->err : e.what();
  const std::string mark = "error: ";
  const std::size_t inner = text.rfind(mark);
  if (inner != std::string::npos) text.erase(0, inner + mark.size());
  text.erase(std::min(text.find(" in function"), text.size()));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  constexpr std::size_t kLongest = 200;
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

/// Whether OpenCV reads the first layers, and runs them unless they cost too much.
bool works(const OnnxGraph& graph, std::size_t layers) {
  try {
    cv::dnn::Net net = read(graph.firstLayers(layers));
    checkCosts(net, graph.input());
    net.setInput(greyImage(graph.input()));
    net.forward();
    return true;
  } catch (const Error&) {
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

/// The first layer that OpenCV cannot read or run, found by bisection.
std::size_t firstFailure(const OnnxGraph& graph) {
  std::size_t good = 0;
  std::size_t bad = graph.layers();
  while (bad - good > 1) {
    const std::size_t middle = (good + bad) / 2;
    (works(graph, middle) ? good : bad) = middle;
  }
  return bad - 1;
}

void checkOutput(const cv::Mat& output, const std::string& of) {
  require(output.type() == CV_32F && (output.dims == 2 || output.dims == 4) &&
              output.size[0] == 1 && output.total() > 0,
          "the output of " + of + " is neither 1 x values nor 1 x values x height x width");
  require(cv::checkRange(output.reshape(1, 1)), "the output of " + of + " is not finite");
}

}  // namespace

void limitOpenCvToOneThread() {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if (cv::getNumThreads() != 1) cv::setNumThreads(1);
}

NetworkRunner::NetworkRunner(const OnnxGraph& graph, const std::vector<int>& strides) {
  limitOpenCvToOneThread();
  const NetworkInput input = graph.input();
  try {
    net_ = read(graph.bytes());
    checkCosts(net_, input);
    layers_ = layersOf(strides, net_, input);
    run(greyImage(input));
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw Error("OpenCV cannot run its layer " + graph.describeLayer(firstFailure(graph)) + ": " +
                reasonOf(e));
  }
  const std::string last = graph.describeLayer(graph.layers() - 1);
  for (std::size_t i = 0; i < strides.size(); ++i) {
    checkOutput(outputs_[i], strides[i] == 0 ? "its layer " + last
                                             : "'stride: " + std::to_string(strides[i]) + "'");
  }
}

void NetworkRunner::run(const cv::Mat& blob) {
  limitOpenCvToOneThread();
  net_.setInput(blob);
  net_.forward(outputs_, layers_);
}

}  // namespace place_recognition
