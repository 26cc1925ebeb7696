#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "features/edge_density.h"
#include "features/feature_extractor.h"
#include "place_recognition/model.h"
#include "place_recognition/training_options.h"
#include "recognition/frames/colour_normalization.h"
#include "recognition/frames/image_scaling.h"
#include "recognition/frames/panorama.h"
#include "recognition/frames/shared_networks.h"

namespace place_recognition {

/// The steps from an image to the feature of each cue, the same in training and recognition: the
/// image is scaled to the working size, a mirror's ring is unrolled, colours are normalized, and
/// each cue's extractor is run. Keeps its buffers: use one per thread.
class CueExtraction {
 public:
  /// For training. `images`: the training images, for their size. A mirror must no longer be
  /// `found`, see withMirror(), and networks must be loaded, see withNetworks().
  CueExtraction(const TrainingOptions& options, const ImageProfile& images);
  /// For recognition with the cues of `model`; those of weight 0 are missing in every image.
  explicit CueExtraction(const Model& model);

  /// Extracts the features of `image` (CV_8UC3 BGR or CV_8UC1, not empty), one per cue, into
  /// `features`, whose memory is reused. False if no cue can be extracted; reason() then says why.
  /// `light`: gains for cues that follow the light of the run.
  bool extract(const cv::Mat& image, std::vector<Feature>& features, const Light& light = {});

  /// The same for one cue at a time: sets the image for extractCue(), which must stay in memory.
  void begin(const cv::Mat& image, const Light& light = {});
  /// False if the feature is missing.
  bool extractCue(std::size_t cue, Feature& feature);

  /// logColour() of the last image, before any normalization; zero if no cue normalizes.
  const Eigen::RowVector3d& colour() const { return colour_; }

  const std::string& reason() const { return reason_; }

  /// Whether the last image has no cue because it shows too little, see InformationOptions.
  bool showsTooLittle() const { return shows_too_little_; }

 private:
  CueExtraction(const TrainingOptions& options, const ImageProfile& images,
                double least_edge_density);

  void judge(const cv::Mat& scaled);

  double least_edge_density_;
  EdgeDensity edge_density_;
  bool shows_too_little_ = false;
  ImageScaler scaler_;
  Panorama panorama_;
  SharedNetworks networks_;
  std::vector<std::unique_ptr<FeatureExtractor>> extractors_;  // null: the cue is not used
  std::vector<ColourNormalization> normalizations_;            // by cue
  std::vector<bool> logarithmic_;                              // by cue: of the levels it sees
  bool normalizes_ = false;
  Eigen::RowVector3d colour_ = Eigen::RowVector3d::Zero();
  NormalizedImage normalized_;
  std::string reason_;
};

}  // namespace place_recognition
