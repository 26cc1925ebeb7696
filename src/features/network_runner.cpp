#include "features/network_runner.h"

#include <algorithm>
#include <exception>
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

/// Output of the network for a mid-grey image.
cv::Mat firstOutput(cv::dnn::Net& net, const NetworkInput& input) {
  net.setInput(cv::Mat(shapeOf(input), CV_32F, cv::Scalar(0.1)));
  return net.forward();
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

bool works(const OnnxGraph& graph, std::size_t layers) {
  try {
    cv::dnn::Net net = read(graph.firstLayers(layers));
    firstOutput(net, graph.input());
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

}  // namespace

void limitOpenCvToOneThread() {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if (cv::getNumThreads() != 1) cv::setNumThreads(1);
}

NetworkRunner::NetworkRunner(const OnnxGraph& graph) {
  limitOpenCvToOneThread();
  const NetworkInput input = graph.input();
  try {
    net_ = read(graph.bytes());
    checkCosts(net_, input);
    output_ = firstOutput(net_, input);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw Error("OpenCV cannot run its layer " + graph.describeLayer(firstFailure(graph)) + ": " +
                reasonOf(e));
  }
  const std::string last = graph.describeLayer(graph.layers() - 1);
  require(output_.type() == CV_32F && (output_.dims == 2 || output_.dims == 4) &&
              output_.size[0] == 1 && output_.total() > 0,
          "the output of its layer " + last +
              " is neither 1 x values nor 1 x values x height x "
              "width");
  require(cv::checkRange(output_.reshape(1, 1)),
          "the output of its layer " + last + " is not finite");
}

const cv::Mat& NetworkRunner::run(const cv::Mat& blob) {
  limitOpenCvToOneThread();
  net_.setInput(blob);
  output_ = net_.forward();
  return output_;
}

}  // namespace place_recognition
