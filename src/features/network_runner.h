#pragma once

#include <opencv2/dnn.hpp>
#include <vector>

#include "features/onnx_graph.h"

namespace place_recognition {

/// Runs a network in OpenCV: an image in, the outputs of the network and of layers within it out.
/// cv::dnn::Net is not thread-safe: use one per thread. Limits OpenCV to one thread, see
/// limitOpenCvToOneThread().
class NetworkRunner {
 public:
  /// `graph` must be cut, and its input shape fixed. `strides`: of the outputs wanted, see
  /// EmbeddingOptions::stride. Runs it once. Throws Error, a phrase that names the layer, if OpenCV
  /// cannot run it, if it would take too much memory or time, or if no layer has such a stride.
  NetworkRunner(const OnnxGraph& graph, const std::vector<int>& strides);

  /// `blob`: 1 x channels x height x width, as the graph declares. Throws cv::Exception on failure.
  void run(const cv::Mat& blob);

  /// The output of the i-th stride: 1 x values, or 1 x values x height x width, valid until the
  /// next run.
  const cv::Mat& output(std::size_t i) const { return outputs_[i]; }
  /// Number of values in this output, without its height and width.
  std::size_t dimension(std::size_t i) const {
    return static_cast<std::size_t>(outputs_[i].size[1]);
  }
  /// Width of this output; 1 if it has none.
  int width(std::size_t i) const { return outputs_[i].dims == 4 ? outputs_[i].size[3] : 1; }

 private:
  cv::dnn::Net net_;
  std::vector<cv::String> layers_;  ///< of the outputs
  std::vector<cv::Mat> outputs_;
};

}  // namespace place_recognition
