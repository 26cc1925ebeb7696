#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/feature.h"
#include "place_recognition/light.h"
#include "place_recognition/model.h"

namespace place_recognition {

class CueBudget;
class CueExtraction;
class CueMean;
class EvidenceShift;
class LightEstimate;
class RateLimit;

/// The answer to one frame.
struct Recognition {
  int place = -1;         ///< index of the most probable place in Model::places; -1: none at all
  bool known = false;     ///< false: the answer is 'unknown'; evidence below the threshold
  double confidence = 0;  ///< probability of `place`, 0..1
  double evidence = 0;    ///< that it is any of the places, 0..1; below the threshold: 'unknown'
  Eigen::RowVectorXd probabilities;    ///< one per place; sum to 1, the largest is `place`
  Eigen::RowVectorXd decision_values;  ///< one per place; as they come from the machines
  std::string reason;                  ///< why place is -1, for a person
  std::vector<std::size_t> held;       ///< cues that were not computed for this frame, ascending
};

/// Image in, answer out. Keeps its buffers between frames: one recognizer a thread, any number of
/// recognizers a model.
class Recognizer {
 public:
  explicit Recognizer(std::shared_ptr<const Model> model);
  ~Recognizer();
  Recognizer(Recognizer&&) noexcept;
  Recognizer& operator=(Recognizer&&) noexcept;

  /// An image by itself, of whose light nothing is known: CV_8UC3 in BGR order or CV_8UC1, not
  /// empty. The result stays valid until the next call. An image from which no cue could be
  /// extracted, or that shows one colour or too little (InformationOptions), has place -1, uniform
  /// probabilities and a reason.
  const Recognition& recognize(const cv::Mat& image);

  /// The next frame of a stream, of `stamp`, s: those before it that are neither black nor white
  /// tell the light, which cues with `normalize: run` need, and how evident the places are in it,
  /// see evidenceShift(). A stamp more than a second before the last one begins a new stream.
  /// `seconds`: how long the answer may take. Cues for which that will not do, by what they took in
  /// the frames before, are held; one cue at least is computed, the quickest.
  const Recognition& recognize(const cv::Mat& image, double stamp,
                               double seconds = std::numeric_limits<double>::infinity());

  /// The next frame begins a new stream.
  void forgetStream();

  /// Cues of type `embedding`, which cost much, are computed for at most `rate` frames of a stream
  /// a second, and held in between; 0: for each.
  void setEmbeddingRate(double rate) { embedding_rate_ = rate; }

  /// The last decision values of a cue that is held count by its weight times e^(-age / time): what
  /// was seen tells of what is seen now for about as long. `time`, s: 0, as it is until set, lets
  /// them count for nothing.
  void setDecorrelationTime(double time) { decorrelation_time_ = time; }

  /// What frames of the current stream are to be multiplied by to look as in the training, by what
  /// its frames so far have shown.
  const Light& lightCorrection() const;

  /// By how much the places are less evident in the frames of the current stream than they were
  /// in the training, which Recognition::evidence makes up for: log odds, 0..4.
  double evidenceShift() const;

  /// The model's threshold until set: evidence below it is answered 'unknown', 0..1.
  void setUnknownThreshold(double threshold) { unknown_threshold_ = threshold; }

  const Model& model() const { return *model_; }

 private:
  /// What one cue says of an image.
  struct CueAnswer {
    bool missing = true;
    double stamp = 0;  // of the image
    Eigen::RowVectorXd decision_values;
    double familiarity = 0;  // the largest kernel value
  };
  using CueAnswers = std::vector<CueAnswer>;

  void beginStreamFrame(double stamp);
  void askCue(std::size_t cue, double stamp, CueAnswer& answer);
  void askCuesInTime(double stamp);
  double weightOf(std::size_t cue, double certainty, double age) const;
  const Recognition& combine(const CueAnswers& answers, double stamp, double certainty,
                             double evidence_shift);
  void decide(double evidence_shift);
  const Recognition& answerNothing(const std::string& reason);

  std::shared_ptr<const Model> model_;
  std::unique_ptr<CueExtraction> extraction_;
  std::unique_ptr<LightEstimate> light_;
  double unknown_light_;  // certainty of the light of an image by itself
  std::unique_ptr<EvidenceShift> evidence_shift_;
  std::vector<bool> follows_run_;   // of each cue: normalize is run
  std::vector<bool> is_embedding_;  // of each cue
  double embedding_rate_ = 0;
  double decorrelation_time_ = 0;
  std::unique_ptr<RateLimit> embedding_limit_;
  std::unique_ptr<CueBudget> budget_;
  double stamp_ = 0;  // of the last frame of the stream
  double unknown_threshold_;
  std::vector<Feature> features_;  // one per cue
  CueAnswers stream_answers_;      // to the last frame of the stream, or held
  CueAnswers image_answers_;       // to an image by itself
  Eigen::VectorXd kernel_values_;
  std::unique_ptr<CueMean> mean_;  // of the cues that count
  double log_odds_ = 0;            // of evidence, without the shift
  Recognition recognition_;
};

}  // namespace place_recognition
