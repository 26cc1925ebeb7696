#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "features/feature_extractor.h"
#include "place_recognition/embedding_options.h"

namespace place_recognition {

class NetworkPass;

/// The output of a network as a DenseVector of L2 norm one, averaged over its height and width if
/// it has them; with a power, by the generalized mean (Radenovic et al. 2019, eq. 3). With several
/// columns, the averages over the whole and over each column follow one another; the columns
/// together have the norm of the whole (a spatial pyramid, Lazebnik et al. 2006). Runs in OpenCV's
/// dnn module.
class EmbeddingExtractor : public FeatureExtractor {
 public:
  /// Loads the network unless the options contain it. Throws like loadNetwork() and NetworkPass.
  explicit EmbeddingExtractor(const EmbeddingOptions& options);
  /// `shared`: a pass of these options, too. The caller makes it forget before each image.
  EmbeddingExtractor(const EmbeddingOptions& options, std::shared_ptr<NetworkPass> shared);
  ~EmbeddingExtractor() override;

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  /// Averages the network's output. False if all of it is zero.
  bool pool(const cv::Mat& output, std::vector<float>& values) const;

  int stride_;
  int columns_;
  int power_;
  bool is_shared_;
  std::shared_ptr<NetworkPass> pass_;
};

}  // namespace place_recognition
