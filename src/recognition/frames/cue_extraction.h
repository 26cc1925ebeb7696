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

namespace place_recognition {

/// The road from an image to the feature of each cue, the same in training and in recognition: the
/// image is brought to the size that is worked at, that of a mirror is unrolled, its colours are
/// normalized, then each cue's extractor looks at it. Keeps its buffers from image to image: one
/// per thread.
class CueExtraction {
 public:
  /// For training. `images`: what the model is trained on, for their size. A mirror must not be to
  /// be `found` any more, see withMirror().
  CueExtraction(const TrainingOptions& options, const ImageProfile& images);
  /// For recognition: the cues of `model` that count, those of weight 0 are missing in every image.
  explicit CueExtraction(const Model& model);

  /// Features of `image` (CV_8UC3 BGR or CV_8UC1, not empty), one per cue, into `features`, whose
  /// memory is reused. False if no cue could be extracted; reason() then says why.
  /// `light`: what cues that follow the light of the run multiply the image by.
  bool extract(const cv::Mat& image, std::vector<Feature>& features, const Light& light = {});

  /// The same a cue at a time: the image that extractCue() looks at. It must stay where it is.
  void begin(const cv::Mat& image, const Light& light = {});
  /// False if the feature is missing.
  bool extractCue(std::size_t cue, Feature& feature);

  /// logColor() of the last image, before any normalization; zero if no cue normalizes.
  const Eigen::RowVector3d& colour() const { return colour_; }

  const std::string& reason() const { return reason_; }

  /// Whether the last image had no cue because it shows too little, see InformationOptions.
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
  std::vector<std::unique_ptr<FeatureExtractor>> extractors_;  // none: the cue does not count
  std::vector<ColourNormalization> normalizations_;            // of each cue
  bool normalizes_ = false;
  Eigen::RowVector3d colour_ = Eigen::RowVector3d::Zero();
  NormalizedImage normalized_;
  std::string reason_;
};

}  // namespace place_recognition
