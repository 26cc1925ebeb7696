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
    NetworkRunner runner(graph);
    const std::vector<int> shape{1, 3, 16, 16};
    runner.run(cv::Mat(shape, CV_32F, cv::Scalar(0.5)));
  } catch (const Error&) {
  } catch (const cv::Exception&) {
  }
  return 0;
}
