#include "recognition/frames/cue_extraction.h"

#include <cassert>

namespace place_recognition {

CueExtraction::CueExtraction(const TrainingOptions& options, const ImageProfile& images)
    : scaler_(images, options.image.max_width) {
  for (const CueOptions& cue : options.cues) {
    extractors_.push_back(makeFeatureExtractor(cue.feature));
    normalizations_.push_back(colorNormalization(cue.normalize));
    is_embedding_.push_back(std::holds_alternative<EmbeddingOptions>(cue.feature));
    normalizes_ = normalizes_ || normalizations_.back() != ColorNormalization::kNone;
  }
}

CueExtraction::CueExtraction(const Model& model) : CueExtraction(model.options, model.images) {
  for (std::size_t c = 0; c < extractors_.size(); ++c) {
    if (model.cue_weights[c] == 0) extractors_[c].reset();
  }
}

bool CueExtraction::extract(const cv::Mat& image, std::vector<Feature>& features,
                            const Light& light, bool with_embeddings) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  const cv::Mat& scaled = scaler_.scaled(image);
  if (normalizes_) color_ = logColor(scaled);
  normalized_.set(scaled, color_, light);
  features.resize(extractors_.size());
  reason_.clear();
  bool any = false;
  for (std::size_t c = 0; c < extractors_.size(); ++c) {
    if (!extractors_[c] || (is_embedding_[c] && !with_embeddings)) continue;
    extractors_[c]->extract(normalized_.in(normalizations_[c]), features[c]);
    any = any || !isMissing(features[c]);
    if (isMissing(features[c]) && reason_.empty()) reason_ = extractors_[c]->missingReason();
  }
  return any;
}

}  // namespace place_recognition
