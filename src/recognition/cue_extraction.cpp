#include "recognition/cue_extraction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace place_recognition {

const cv::Mat& scaledDown(const cv::Mat& image, int max_width, cv::Mat& buffer) {
  if (max_width == 0 || image.cols <= max_width) return image;
  const double scale = static_cast<double>(max_width) / image.cols;
  const int height = std::max(1, static_cast<int>(std::lround(image.rows * scale)));
  cv::resize(image, buffer, cv::Size(max_width, height), 0, 0, cv::INTER_AREA);
  return buffer;
}

CueExtraction::CueExtraction(const TrainingOptions& options) : max_width_(options.image.max_width) {
  for (const CueOptions& cue : options.cues) {
    extractors_.push_back(makeFeatureExtractor(cue.feature));
    normalizations_.push_back(colorNormalization(cue.normalize));
    normalizes_ = normalizes_ || normalizations_.back() != ColorNormalization::kNone;
  }
}

bool CueExtraction::extract(const cv::Mat& image, std::vector<Feature>& features,
                            const Light& light) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  const cv::Mat& scaled = scaledDown(image, max_width_, scaled_);
  if (normalizes_) color_ = logColor(scaled);
  normalized_.set(scaled, color_, light);
  features.resize(extractors_.size());
  reason_.clear();
  bool any = false;
  for (std::size_t c = 0; c < extractors_.size(); ++c) {
    extractors_[c]->extract(normalized_.in(normalizations_[c]), features[c]);
    any = any || !isMissing(features[c]);
    if (isMissing(features[c]) && reason_.empty()) reason_ = extractors_[c]->missingReason();
  }
  return any;
}

}  // namespace place_recognition
