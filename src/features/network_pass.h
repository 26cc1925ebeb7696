#pragma once

#include <array>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "place_recognition/embedding_options.h"

namespace place_recognition {

class NetworkRunner;

/// A network on one image at a time: the image is scaled to its input and the network is run, once
/// for all features that share the pass. Not thread-safe.
class NetworkPass {
 public:
  /// `sharing`: options of the features that share the pass, at least one. They contain the network
  /// and differ only in the stride and in how its output is averaged. Throws Error, a phrase that
  /// names network and OpenCV's version, if it cannot be used.
  explicit NetworkPass(const std::vector<EmbeddingOptions>& sharing);
  ~NetworkPass();

  /// The output of this stride for `image`, as NetworkRunner has it; computed only if none is
  /// remembered. Throws cv::Exception if OpenCV fails.
  const cv::Mat& output(const cv::Mat& image, int stride);

  /// Forgets the outputs. To be called before each new image.
  void forget() { has_run_ = false; }

  /// Width of the output of this stride; 1 if it has none.
  int width(int stride) const;

 private:
  std::size_t indexOf(int stride) const;
  void fillBlob(const cv::Mat& image);

  bool crop_;
  std::array<int, 3> sources_{};                    ///< of each channel of the input, one of BGR
  std::array<std::array<float, 256>, 3> values_{};  ///< of each channel, by pixel value
  int channels_;
  std::vector<int> strides_;  ///< in ascending order
  std::unique_ptr<NetworkRunner> runner_;
  bool has_run_ = false;  ///< on the current image
  cv::Mat blob_;          ///< 1 x channels x height x width
  cv::Mat scaled_;        ///< the image at the network's size
  cv::Mat grey_;
};

}  // namespace place_recognition
