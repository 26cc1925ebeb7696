// Feeds arbitrary bytes as an ONNX file.

#include <cmath>
#include <opencv2/core.hpp>

#include "features/network_runner.h"
#include "place_recognition/error.h"

using namespace place_recognition;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    OnnxGraph graph(std::string(reinterpret_cast<const char*>(data), size));
    graph.cutBehind("");
    graph.setInput({3, 16, 16});
    const std::vector<int> shape{1, 3, 16, 16};
    const cv::Mat image(shape, CV_32F, cv::Scalar(0.5));
    NetworkRunner(graph, {0}).run(image);
    NetworkRunner(graph, {0, 2}).run(image);
  } catch (const Error&) {
  } catch (const cv::Exception&) {
  }
  return 0;
}
