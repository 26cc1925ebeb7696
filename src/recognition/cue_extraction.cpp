#include "recognition/cue_extraction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace place_recognition {

CueExtraction::CueExtraction(const TrainingOptions& options) : max_width_(options.image.max_width) {
  for (const CueOptions& cue : options.cues) {
    extractors_.push_back(makeFeatureExtractor(cue.feature));
  }
}

bool CueExtraction::extract(const cv::Mat& image, std::vector<Feature>& features) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  const cv::Mat& scaled = scaledDown(image);
  features.resize(extractors_.size());
  reason_.clear();
  bool any = false;
  for (std::size_t c = 0; c < extractors_.size(); ++c) {
    extractors_[c]->extract(scaled, features[c]);
    any = any || !isMissing(features[c]);
    if (isMissing(features[c]) && reason_.empty()) reason_ = extractors_[c]->missingReason();
  }
  return any;
}

const cv::Mat& CueExtraction::scaledDown(const cv::Mat& image) {
  if (max_width_ == 0 || image.cols <= max_width_) return image;
  const double scale = static_cast<double>(max_width_) / image.cols;
  const int height = std::max(1, static_cast<int>(std::lround(image.rows * scale)));
  cv::resize(image, scaled_, cv::Size(max_width_, height), 0, 0, cv::INTER_AREA);
  return scaled_;
}

}  // namespace place_recognition
