#include "place_recognition/recognizer.h"

#include <algorithm>
#include <cmath>

#include "base/rate_limit.h"
#include "base/time_jump.h"
#include "recognition/frames/cue_extraction.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/light_estimate.h"
#include "recognition/model/cue_mean.h"
#include "recognition/model/embeddings.h"
#include "recognition/model/scores.h"
#include "recognition/recognizer/cue_budget.h"
#include "recognition/recognizer/evidence_shift.h"

namespace place_recognition {
namespace {

const std::string kUniformReason = std::string("the image ") + kUniformProblem;

/// What one cue states about an image.
struct CueAnswer {
  bool missing = true;
  double stamp = 0;  // of the image
  Eigen::RowVectorXd decision_values;
  double familiarity = 0;  // the largest kernel value
};

using CueAnswers = std::vector<CueAnswer>;

/// Whether sums of the answer of a cue are finite: a model file may contain huge numbers.
bool isUsable(double familiarity, const Eigen::RowVectorXd& decision_values) {
  constexpr double kLargest = 1e30;
  return std::abs(familiarity) <= kLargest && (decision_values.array().abs() <= kLargest).all();
}

}  // namespace

/// Its functions are those of Recognizer, and the steps to an answer.
class Recognizer::State {
 public:
  explicit State(std::shared_ptr<const Model> model);

  const Recognition& recognize(const cv::Mat& image);
  const Recognition& recognize(const cv::Mat& image, double stamp, double seconds);
  void forgetStream();
  void setEmbeddingRate(double rate) { embedding_rate_ = rate; }
  void setDecorrelationTime(double time) { decorrelation_time_ = time; }
  void setUnknownThreshold(double threshold) { unknown_threshold_ = threshold; }
  const Light& lightCorrection() const { return light_.correction(); }
  double evidenceShift() const { return evidence_shift_.value(); }
  const Model& model() const { return *model_; }

 private:
  void beginStreamFrame(double stamp);
  void forgetAnswers();
  void askCue(std::size_t cue, double stamp, CueAnswer& answer);
  void askCuesInTime(double stamp);
  double weightOf(std::size_t cue, double certainty, double age) const;
  const Recognition& combine(const CueAnswers& answers, double stamp, double certainty,
                             double evidence_shift);
  void decide(double evidence_shift);
  const Recognition& answerNothing(const std::string& reason);

  std::shared_ptr<const Model> model_;
  CueExtraction extraction_;
  LightEstimate light_;
  double unknown_light_;  // certainty of the light of a single image
  EvidenceShift evidence_shift_;
  std::vector<bool> follows_run_;                 // by cue: normalize is run
  std::vector<bool> is_embedding_;                // by cue
  std::vector<std::vector<std::size_t>> groups_;  // of cues that are computed together
  double embedding_rate_ = 0;
  double decorrelation_time_ = 0;
  RateLimit embedding_limit_;
  CueBudget budget_;
  double stamp_ = 0;  // of the last frame of the stream
  double unknown_threshold_;
  std::vector<Feature> features_;  // one per cue
  CueAnswers stream_answers_;      // to the last frame of the stream, or held
  CueAnswers image_answers_;       // to a single image
  Eigen::VectorXd kernel_values_;
  CueMean mean_;         // of the cues in use
  double log_odds_ = 0;  // of evidence, before the shift
  Recognition recognition_;
};

Recognizer::State::State(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      extraction_(*model_),
      light_(model_->colours),
      unknown_light_(light_.certainty()),
      evidence_shift_(*model_),
      groups_(cuesByNetworkRun(model_->options)),
      budget_(groups_.size()),
      unknown_threshold_(model_->unknown_threshold),
      mean_(model_->decision_limit) {
  for (const CueOptions& cue : model_->options.cues) {
    follows_run_.push_back(colourNormalization(cue.normalize) == ColourNormalization::kRun);
    is_embedding_.push_back(std::holds_alternative<EmbeddingOptions>(cue.feature));
  }
  const Eigen::Index places = static_cast<Eigen::Index>(model_->places.size());
  features_.resize(model_->classifiers.size());
  stream_answers_.resize(model_->classifiers.size());
  image_answers_.resize(model_->classifiers.size());
  recognition_.decision_values.setZero(places);
  recognition_.probabilities.setZero(places);
}

const Recognition& Recognizer::State::recognize(const cv::Mat& image) {
  recognition_.held.clear();
  if (isUniform(statisticsOf(image))) return answerNothing(kUniformReason);
  extraction_.begin(image);
  for (std::size_t c = 0; c < image_answers_.size(); ++c) askCue(c, 0, image_answers_[c]);
  return combine(image_answers_, 0, unknown_light_, 0);
}

const Recognition& Recognizer::State::recognize(const cv::Mat& image, double stamp,
                                                double seconds) {
  budget_.begin(seconds);
  beginStreamFrame(stamp);
  recognition_.held.clear();
  if (isUniform(statisticsOf(image))) return answerNothing(kUniformReason);
  extraction_.begin(image, light_.correction());
  askCuesInTime(stamp);
  combine(stream_answers_, stamp, light_.certainty(), evidence_shift_.value());
  light_.add(extraction_.colour(), recognition_.probabilities);
  if (recognition_.place >= 0) {
    evidence_shift_.add(recognition_.probabilities, mean_.unlimited(), log_odds_);
  }
  return recognition_;
}

void Recognizer::State::forgetStream() {
  light_.reset();
  evidence_shift_.reset();
  embedding_limit_.reset();
  forgetAnswers();
}

void Recognizer::State::forgetAnswers() {
  for (CueAnswer& answer : stream_answers_) answer.missing = true;
}

void Recognizer::State::beginStreamFrame(double stamp) {
  light_.beginFrame(stamp);
  evidence_shift_.beginFrame(stamp);
  if (stamp < stamp_) embedding_limit_.reset();
  if (stamp < stamp_ - kTimeJump) forgetAnswers();
  stamp_ = stamp;
}

/// Answers the image that extraction_ has begun.
void Recognizer::State::askCue(std::size_t cue, double stamp, CueAnswer& answer) {
  Feature& feature = features_[cue];
  answer.missing = !extraction_.extractCue(cue, feature) || model_->cue_weights[cue] == 0;
  answer.stamp = stamp;
  if (answer.missing) return;
  model_->classifiers[cue].decisionValues(feature, kernel_values_, answer.decision_values);
  answer.familiarity = kernel_values_.size() > 0 ? kernel_values_.maxCoeff() : 0;
  answer.missing = !isUsable(answer.familiarity, answer.decision_values);
}

/// Computes the cues that are due and fit into the time; the others are held.
void Recognizer::State::askCuesInTime(double stamp) {
  const bool embeddings_are_due = embedding_limit_.admits(stamp, embedding_rate_);
  bool answered = false;
  for (const std::size_t g : budget_.order()) {
    const std::vector<std::size_t>& cues = groups_[g];
    const bool due = embeddings_are_due || !is_embedding_[cues.front()];
    const bool late = due && answered && !budget_.fits(g);
    if (late) budget_.leaveOut(g);
    if (!due || late) {
      recognition_.held.insert(recognition_.held.end(), cues.begin(), cues.end());
      continue;
    }
    budget_.time(g, [&] {
      for (const std::size_t c : cues) askCue(c, stamp, stream_answers_[c]);
    });
    for (const std::size_t c : cues) answered = answered || !stream_answers_[c].missing;
  }
  std::sort(recognition_.held.begin(), recognition_.held.end());
}

const Recognition& Recognizer::State::combine(const CueAnswers& answers, double stamp,
                                              double certainty, double evidence_shift) {
  mean_.begin(static_cast<Eigen::Index>(model_->places.size()));
  for (std::size_t c = 0; c < answers.size(); ++c) {
    if (answers[c].missing) continue;
    mean_.add(weightOf(c, certainty, stamp - answers[c].stamp), answers[c].decision_values,
              answers[c].familiarity);
  }
  if (!extraction_.showsTooLittle() && mean_.finish()) {
    decide(evidence_shift);
  } else {
    answerNothing(extraction_.reason());
  }
  return recognition_;
}

/// What a cue counts: if it follows the light of the run, by the certainty of it; if its decision
/// values are held, by their age, s. Time may have jumped back since.
double Recognizer::State::weightOf(std::size_t cue, double certainty, double age) const {
  double weight = model_->cue_weights[cue];
  if (follows_run_[cue]) weight *= certainty;
  if (age < 0 || (age > 0 && decorrelation_time_ == 0)) return 0;
  return age > 0 ? weight * std::exp(-age / decorrelation_time_) : weight;
}

void Recognizer::State::decide(double evidence_shift) {
  recognition_.decision_values = mean_.decisionValues();
  recognition_.probabilities = model_->calibration.probabilities(recognition_.decision_values);
  recognition_.place = largest(recognition_.probabilities);
  recognition_.confidence = recognition_.probabilities[recognition_.place];
  log_odds_ = model_->calibration.logOdds(mean_.unlimited(), mean_.familiarity());
  recognition_.evidence = logistic(log_odds_ + evidence_shift);
  recognition_.known = recognition_.evidence >= unknown_threshold_;
  recognition_.reason.clear();
}

const Recognition& Recognizer::State::answerNothing(const std::string& reason) {
  const double places = static_cast<double>(model_->places.size());
  recognition_.decision_values.setZero();
  recognition_.probabilities.setConstant(1 / places);
  recognition_.place = -1;
  recognition_.confidence = 0;
  recognition_.evidence = 0;
  recognition_.known = false;
  recognition_.reason = reason.empty() ? "the image has no feature of a cue in use" : reason;
  return recognition_;
}

Recognizer::Recognizer(std::shared_ptr<const Model> model)
    : state_(std::make_unique<State>(std::move(model))) {}
Recognizer::~Recognizer() = default;
Recognizer::Recognizer(Recognizer&&) noexcept = default;
Recognizer& Recognizer::operator=(Recognizer&&) noexcept = default;

const Recognition& Recognizer::recognize(const cv::Mat& image) { return state_->recognize(image); }
const Recognition& Recognizer::recognize(const cv::Mat& image, double stamp, double seconds) {
  return state_->recognize(image, stamp, seconds);
}
void Recognizer::forgetStream() { state_->forgetStream(); }
void Recognizer::setEmbeddingRate(double rate) { state_->setEmbeddingRate(rate); }
void Recognizer::setDecorrelationTime(double time) { state_->setDecorrelationTime(time); }
void Recognizer::setUnknownThreshold(double threshold) { state_->setUnknownThreshold(threshold); }
const Light& Recognizer::lightCorrection() const { return state_->lightCorrection(); }
double Recognizer::evidenceShift() const { return state_->evidenceShift(); }
const Model& Recognizer::model() const { return state_->model(); }

}  // namespace place_recognition
