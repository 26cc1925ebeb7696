#pragma once

#include <opencv2/dnn.hpp>

#include "features/onnx_graph.h"

namespace place_recognition {

/// Runs a network in OpenCV: an image in, a vector out. cv::dnn::Net is not thread-safe: use one
/// per thread. Limits OpenCV to one thread, see limitOpenCvToOneThread().
class NetworkRunner {
 public:
  /// `graph` must be cut, and its input shape fixed. Runs it once. Throws Error, a phrase that
  /// names the layer, if OpenCV cannot run it or if it would take too much memory or time.
  explicit NetworkRunner(const OnnxGraph& graph);

  /// `blob`: 1 x channels x height x width, as the graph declares. The output is 1 x values, or 1 x
  /// values x height x width, valid until the next call. Throws cv::Exception on failure.
  const cv::Mat& run(const cv::Mat& blob);

  /// Number of values in the output, without its height and width.
  std::size_t dimension() const { return static_cast<std::size_t>(output_.size[1]); }
  /// Width of the output; 1 if it has none.
  int width() const { return output_.dims == 4 ? output_.size[3] : 1; }

 private:
  cv::dnn::Net net_;
  cv::Mat output_;
};

}  // namespace place_recognition
