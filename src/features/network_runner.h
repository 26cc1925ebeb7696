#pragma once

#include <opencv2/dnn.hpp>

#include "features/onnx_graph.h"

namespace place_recognition {

/// A network as OpenCV runs it: an image in, a vector out. cv::dnn::Net is not thread-safe: one per
/// thread.
class NetworkRunner {
 public:
  /// `graph` is cut and of no open shape. Runs it once. Throws Error, a phrase that names the
  /// layer, if OpenCV does not run it or if it would take too much memory or time.
  explicit NetworkRunner(const OnnxGraph& graph);

  /// `blob`: 1 x channels x height x width, as the graph declares. The output: 1 x values, or
  /// 1 x values x height x width. Valid until the next call. Throws cv::Exception if it fails.
  const cv::Mat& run(const cv::Mat& blob);

  /// Values in the output, without its height and width.
  std::size_t dimension() const { return static_cast<std::size_t>(output_.size[1]); }

 private:
  cv::dnn::Net net_;
  cv::Mat output_;
};

}  // namespace place_recognition
