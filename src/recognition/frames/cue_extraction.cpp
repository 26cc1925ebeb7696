#include "recognition/frames/cue_extraction.h"

#include <algorithm>
#include <cassert>

#include "base/text.h"

namespace place_recognition {
namespace {

/// Whether the feature is one of logarithmic levels. If so, it becomes that of linear levels, to be
/// extracted from the logarithms, which several cues share.
bool takeLogarithmicLevels(FeatureOptions& feature) {
  auto* const crfh = std::get_if<CrfhOptions>(&feature);
  if (!crfh || crfh->levels != "logarithmic") return false;
  crfh->levels = "linear";
  return true;
}

}  // namespace

CueExtraction::CueExtraction(const TrainingOptions& options, const ImageProfile& images)
    : CueExtraction(options, images, options.information.left_out_below) {}

CueExtraction::CueExtraction(const Model& model)
    : CueExtraction(model.options, model.images, model.options.information.unknown_below) {
  for (std::size_t c = 0; c < extractors_.size(); ++c) {
    if (model.cue_weights[c] == 0) extractors_[c].reset();
  }
}

CueExtraction::CueExtraction(const TrainingOptions& options, const ImageProfile& images,
                             double least_edge_density)
    : least_edge_density_(least_edge_density),
      scaler_(images, options.image.max_width),
      panorama_(options.image.panorama),
      networks_(options.cues) {
  for (const CueOptions& cue : options.cues) {
    CueOptions extracted = cue;
    logarithmic_.push_back(takeLogarithmicLevels(extracted.feature));
    extractors_.push_back(networks_.extractor(extracted));
    normalizations_.push_back(colourNormalization(cue.normalize));
    normalizes_ = normalizes_ || normalizations_.back() != ColourNormalization::kNone;
  }
}

bool CueExtraction::extract(const cv::Mat& image, std::vector<Feature>& features,
                            const Light& light) {
  begin(image, light);
  features.resize(extractors_.size());
  bool any = false;
  for (std::size_t c = 0; c < features.size(); ++c) any |= extractCue(c, features[c]);
  return any;
}

void CueExtraction::begin(const cv::Mat& image, const Light& light) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  const cv::Mat& prepared = panorama_.unrolled(scaler_.scaled(image));
  if (normalizes_) colour_ = logColour(prepared);
  reason_.clear();
  networks_.forget();
  judge(prepared);
  if (!shows_too_little_) normalized_.set(prepared, colour_, light);
}

bool CueExtraction::extractCue(std::size_t cue, Feature& feature) {
  if (!extractors_[cue] || shows_too_little_) {
    feature = {};
    return false;
  }
  const ColourNormalization normalization = normalizations_[cue];
  extractors_[cue]->extract(
      logarithmic_[cue] ? normalized_.logarithms(normalization) : normalized_.in(normalization),
      feature);
  if (!isMissing(feature)) return true;
  if (reason_.empty()) reason_ = extractors_[cue]->missingReason();
  return false;
}

void CueExtraction::judge(const cv::Mat& scaled) {
  if (least_edge_density_ == 0) return;
  const double density = edge_density_.of(scaled);
  shows_too_little_ = density < least_edge_density_;
  if (!shows_too_little_) return;
  reason_ = "the image shows too little: its edge density is " + fixed(density, 3) + ", below " +
            significant(least_edge_density_);
}

}  // namespace place_recognition
