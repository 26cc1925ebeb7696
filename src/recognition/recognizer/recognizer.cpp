#include "place_recognition/recognizer.h"

#include <algorithm>
#include <cmath>

#include "base/rate_limit.h"
#include "recognition/frames/cue_extraction.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/light_estimate.h"
#include "recognition/model/cue_mean.h"
#include "recognition/model/scores.h"
#include "recognition/recognizer/evidence_shift.h"

namespace place_recognition {
namespace {

const std::string kUniformReason = std::string("the image ") + kUniformProblem;

}  // namespace

Recognizer::Recognizer(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      extraction_(std::make_unique<CueExtraction>(*model_)),
      light_(std::make_unique<LightEstimate>(model_->colours)),
      unknown_light_(light_->certainty()),
      evidence_shift_(std::make_unique<EvidenceShift>(*model_)),
      embedding_limit_(std::make_unique<RateLimit>()),
      unknown_threshold_(model_->unknown_threshold),
      mean_(std::make_unique<CueMean>()) {
  for (const CueOptions& cue : model_->options.cues) {
    follows_run_.push_back(colourNormalization(cue.normalize) == ColourNormalization::kRecording);
    is_embedding_.push_back(std::holds_alternative<EmbeddingOptions>(cue.feature));
  }
  const Eigen::Index places = static_cast<Eigen::Index>(model_->places.size());
  stream_answers_.resize(model_->classifiers.size());
  image_answers_.resize(model_->classifiers.size());
  recognition_.decision_values.setZero(places);
  recognition_.probabilities.setZero(places);
}

Recognizer::~Recognizer() = default;
Recognizer::Recognizer(Recognizer&&) noexcept = default;
Recognizer& Recognizer::operator=(Recognizer&&) noexcept = default;

const Recognition& Recognizer::recognize(const cv::Mat& image) {
  if (isUniform(statisticsOf(image))) return answerNothing(kUniformReason);
  askCues({}, image, true, image_answers_);
  return combine(image_answers_, unknown_light_, false, 0);
}

const Recognition& Recognizer::recognize(const cv::Mat& image, double stamp) {
  light_->beginFrame(stamp);
  evidence_shift_->beginFrame(stamp);
  if (isUniform(statisticsOf(image))) return answerNothing(kUniformReason);
  const bool compute = embeddingsAreDue(stamp);
  if (compute) embedding_stamp_ = stamp;
  stamp_ = stamp;
  askCues(light_->correction(), image, compute, stream_answers_);
  combine(stream_answers_, light_->certainty(), !compute, evidence_shift_->value());
  light_->add(extraction_->colour(), recognition_.probabilities);
  if (recognition_.place >= 0) {
    evidence_shift_->add(recognition_.probabilities, recognition_.decision_values, log_odds_);
  }
  return recognition_;
}

const Light& Recognizer::lightCorrection() const { return light_->correction(); }

void Recognizer::forgetStream() {
  light_->reset();
  evidence_shift_->reset();
  embedding_limit_->reset();
}

double Recognizer::evidenceShift() const { return evidence_shift_->value(); }

void Recognizer::setEmbeddingRate(double rate, double decorrelation_time) {
  embedding_rate_ = rate;
  decorrelation_time_ = decorrelation_time;
}

bool Recognizer::embeddingsAreDue(double stamp) {
  if (stamp < stamp_) embedding_limit_->reset();
  return embedding_limit_->admits(stamp, embedding_rate_);
}

/// Leaves the answers of embeddings as they are unless `with_embeddings`.
void Recognizer::askCues(const Light& light, const cv::Mat& image, bool with_embeddings,
                         CueAnswers& answers) {
  extraction_->extract(image, features_, light, with_embeddings);
  for (std::size_t c = 0; c < features_.size(); ++c) {
    if (is_embedding_[c] && !with_embeddings) continue;
    CueAnswer& answer = answers[c];
    answer.missing = isMissing(features_[c]) || model_->cue_weights[c] == 0;
    if (answer.missing) continue;
    model_->classifiers[c].decisionValues(features_[c], kernel_values_, answer.decision_values);
    answer.familiarity = kernel_values_.size() > 0 ? kernel_values_.maxCoeff() : 0;
  }
}

const Recognition& Recognizer::combine(const CueAnswers& answers, double certainty,
                                       bool embeddings_are_held, double evidence_shift) {
  mean_->begin(static_cast<Eigen::Index>(model_->places.size()));
  for (std::size_t c = 0; c < answers.size(); ++c) {
    if (answers[c].missing) continue;
    mean_->add(weightOf(c, certainty, embeddings_are_held), answers[c].decision_values,
               answers[c].familiarity);
  }
  if (!extraction_->showsTooLittle() && mean_->finish()) {
    decide(evidence_shift);
  } else {
    answerNothing(extraction_->reason());
  }
  return recognition_;
}

/// What a cue counts: if it follows the light of the run, by the certainty of it; if its decision
/// values are held, by their age.
double Recognizer::weightOf(std::size_t cue, double certainty, bool embeddings_are_held) const {
  double weight = model_->cue_weights[cue];
  if (follows_run_[cue]) weight *= certainty;
  if (is_embedding_[cue] && embeddings_are_held) {
    weight *=
        decorrelation_time_ > 0 ? std::exp((embedding_stamp_ - stamp_) / decorrelation_time_) : 0;
  }
  return weight;
}

void Recognizer::decide(double evidence_shift) {
  recognition_.decision_values = mean_->decisionValues();
  recognition_.probabilities = model_->calibration.probabilities(recognition_.decision_values);
  recognition_.place = largest(recognition_.probabilities);
  recognition_.confidence = recognition_.probabilities[recognition_.place];
  log_odds_ = model_->calibration.logOdds(recognition_.decision_values, mean_->familiarity());
  recognition_.evidence = logistic(log_odds_ + evidence_shift);
  recognition_.known = recognition_.evidence >= unknown_threshold_;
  recognition_.reason.clear();
}

const Recognition& Recognizer::answerNothing(const std::string& reason) {
  const double places = static_cast<double>(model_->places.size());
  recognition_.decision_values.setZero();
  recognition_.probabilities.setConstant(1 / places);
  recognition_.place = -1;
  recognition_.confidence = 0;
  recognition_.evidence = 0;
  recognition_.known = false;
  recognition_.reason = reason.empty() ? "the image has no feature of a cue that counts" : reason;
  return recognition_;
}

}  // namespace place_recognition
