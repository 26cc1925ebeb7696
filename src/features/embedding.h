#pragma once

#include <array>
#include <memory>
#include <opencv2/core.hpp>

#include "features/feature_extractor.h"
#include "place_recognition/embedding_options.h"

namespace place_recognition {

class NetworkRunner;

/// The output of a network as a DenseVector of L2 norm one, averaged over its height and width if
/// it has them. Runs in OpenCV's dnn module.
class EmbeddingExtractor : public FeatureExtractor {
 public:
  /// Loads the network unless the options contain it; this throws like loadNetwork(). Throws Error,
  /// a phrase that names network, layer and OpenCV's version, if a contained network cannot be
  /// used.
  explicit EmbeddingExtractor(const EmbeddingOptions& options);
  ~EmbeddingExtractor() override;

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  void fillBlob(const cv::Mat& image);

  bool crop_;
  std::array<int, 3> sources_{};                    ///< of each channel of the input, one of BGR
  std::array<std::array<float, 256>, 3> values_{};  ///< of each channel, by pixel value
  int channels_;
  std::unique_ptr<NetworkRunner> runner_;
  cv::Mat blob_;    ///< 1 x channels x height x width
  cv::Mat scaled_;  ///< the image at the network's size
  cv::Mat grey_;
};

}  // namespace place_recognition
