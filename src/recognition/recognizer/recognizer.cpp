#include "place_recognition/recognizer.h"

#include <algorithm>

#include "recognition/frames/cue_extraction.h"
#include "recognition/model/scores.h"
#include "recognition/recognizer/light_estimate.h"

namespace place_recognition {

Recognizer::Recognizer(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      extraction_(std::make_unique<CueExtraction>(*model_)),
      light_(std::make_unique<LightEstimate>(model_->colors)),
      unknown_light_(light_->certainty()),
      unknown_threshold_(model_->unknown_threshold) {
  for (const CueOptions& cue : model_->options.cues) {
    follows_run_.push_back(colorNormalization(cue.normalize) == ColorNormalization::kRun);
  }
  const Eigen::Index places = static_cast<Eigen::Index>(model_->places.size());
  cue_margins_.setZero(places);
  recognition_.margins.setZero(places);
  recognition_.probabilities.setZero(places);
}

Recognizer::~Recognizer() = default;
Recognizer::Recognizer(Recognizer&&) noexcept = default;
Recognizer& Recognizer::operator=(Recognizer&&) noexcept = default;

const Recognition& Recognizer::recognize(const cv::Mat& image) {
  return recognizeIn({}, unknown_light_, image);
}

const Recognition& Recognizer::recognize(const cv::Mat& image, double stamp) {
  light_->beginFrame(stamp);
  recognizeIn(light_->correction(), light_->certainty(), image);
  light_->add(extraction_->color(), recognition_.probabilities);
  return recognition_;
}

void Recognizer::forgetLight() { light_->reset(); }

const Recognition& Recognizer::recognizeIn(const Light& light, double certainty,
                                           const cv::Mat& image) {
  extraction_->extract(image, features_, light);
  if (sumMargins(certainty)) {
    decide();
  } else {
    answerNothing(extraction_->reason());
  }
  return recognition_;
}

/// Weighted mean of the margins, and of the familiarity, of the cues that the image has, those that
/// follow the light of the run by the certainty of it; false if there is none that counts. Dividing
/// by the weights present keeps the sum in the units that the calibration was fitted in.
bool Recognizer::sumMargins(double certainty) {
  recognition_.margins.setZero();
  familiarity_ = 0;
  double present = 0;
  for (std::size_t c = 0; c < features_.size(); ++c) {
    const double weight = model_->cue_weights[c] * (follows_run_[c] ? certainty : 1);
    if (weight == 0 || isMissing(features_[c])) continue;
    model_->classifiers[c].margins(features_[c], kernel_values_, cue_margins_);
    recognition_.margins += weight * cue_margins_;
    if (kernel_values_.size() > 0) familiarity_ += weight * kernel_values_.maxCoeff();
    present += weight;
  }
  if (present == 0) return false;
  recognition_.margins /= present;
  familiarity_ /= present;
  return true;
}

void Recognizer::decide() {
  recognition_.probabilities = model_->calibration.probabilities(recognition_.margins);
  recognition_.place = largest(recognition_.probabilities);
  recognition_.confidence = recognition_.probabilities[recognition_.place];
  recognition_.evidence = model_->calibration.evidence(recognition_.margins, familiarity_);
  recognition_.known = recognition_.evidence >= unknown_threshold_;
  recognition_.reason.clear();
}

void Recognizer::answerNothing(const std::string& reason) {
  const double places = static_cast<double>(model_->places.size());
  recognition_.margins.setZero();
  recognition_.probabilities.setConstant(1 / places);
  recognition_.place = -1;
  recognition_.confidence = 0;
  recognition_.evidence = 0;
  recognition_.known = false;
  recognition_.reason = reason.empty() ? "the image has no feature of a cue that counts" : reason;
}

}  // namespace place_recognition
