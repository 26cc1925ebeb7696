#pragma once

#include <array>
#include <memory>
#include <opencv2/core.hpp>

#include "place_recognition/embedding_options.h"

namespace place_recognition {

class NetworkRunner;

/// A network on one image at a time: the image is scaled to its input and the network is run, once
/// for all features that share the pass. Not thread-safe.
class NetworkPass {
 public:
  /// Loads the network unless the options contain it; this throws like loadNetwork(). Throws Error,
  /// a phrase that names network and OpenCV's version, if a contained network cannot be used.
  explicit NetworkPass(const EmbeddingOptions& options);
  ~NetworkPass();

  /// The output for `image`, as NetworkRunner has it; computed only if none is remembered. Throws
  /// cv::Exception if OpenCV fails.
  const cv::Mat& output(const cv::Mat& image);

  /// Forgets the output. To be called before each new image.
  void forget() { output_ = nullptr; }

  /// Width of the output; 1 if it has none.
  int width() const;

 private:
  void fillBlob(const cv::Mat& image);

  bool crop_;
  std::array<int, 3> sources_{};                    ///< of each channel of the input, one of BGR
  std::array<std::array<float, 256>, 3> values_{};  ///< of each channel, by pixel value
  int channels_;
  std::unique_ptr<NetworkRunner> runner_;
  const cv::Mat* output_ = nullptr;  ///< null: not computed for the current image
  cv::Mat blob_;                     ///< 1 x channels x height x width
  cv::Mat scaled_;                   ///< the image at the network's size
  cv::Mat grey_;
};

}  // namespace place_recognition
