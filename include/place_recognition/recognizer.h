#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/light.h"
#include "place_recognition/model.h"

namespace place_recognition {

/// The answer to one frame.
struct Recognition {
  int place = -1;         ///< index of the most probable place in Model::places; -1: no answer
  bool known = false;     ///< whether evidence reaches the threshold; false: answered 'unknown'
  double confidence = 0;  ///< probability of `place`, 0..1
  double evidence = 0;    ///< that the frame shows any of the places, 0..1
  Eigen::RowVectorXd probabilities;    ///< one per place; they sum to 1, `place` has the largest
  Eigen::RowVectorXd decision_values;  ///< one per place: the mean of the cues'
  std::string reason;                  ///< why place is -1, for a person
  std::vector<std::size_t> held;       ///< cues not computed for this frame, ascending
};

/// Maps an image to an answer. Keeps its buffers between frames: use one recognizer per thread; any
/// number of recognizers may share a model.
class Recognizer {
 public:
  explicit Recognizer(std::shared_ptr<const Model> model);
  ~Recognizer();
  Recognizer(Recognizer&&) noexcept;
  Recognizer& operator=(Recognizer&&) noexcept;

  /// Recognizes a single image, in unknown light: CV_8UC3 in BGR order or CV_8UC1, not empty. The
  /// result stays valid until the next call. An image from which no cue can be extracted, or that
  /// shows a single colour or too little (InformationOptions), has place -1, uniform probabilities
  /// and a reason.
  const Recognition& recognize(const cv::Mat& image);

  /// Recognizes the next frame of a stream, with its `stamp`, s. Earlier frames that are neither
  /// black nor white determine the light, which cues with `normalize: run` need, and how evident
  /// the places are in it, see evidenceShift(). A stamp more than a second before the last one
  /// begins a new stream. `seconds` limits the time for the answer. Cues that would exceed it,
  /// judging by their times in earlier frames, are held, see setDecorrelationTime(). At least one
  /// cue is computed, the quickest.
  const Recognition& recognize(const cv::Mat& image, double stamp,
                               double seconds = std::numeric_limits<double>::infinity());

  /// Makes the next frame begin a new stream.
  void forgetStream();

  /// Limits cues of type `embedding`, which are expensive, to `rate` frames per second of a stream;
  /// they are held in between. 0: no limit.
  void setEmbeddingRate(double rate);

  /// Sets the decorrelation time, s. The last decision values of a held cue count with the cue's
  /// weight times e^(-age / time), because a view predicts later views for about as long. 0, the
  /// default: they do not count.
  void setDecorrelationTime(double time);

  /// The gains that make frames of the current stream look as in the training, estimated from its
  /// frames so far.
  const Light& lightCorrection() const;

  /// How much less evident the places are in the current stream than in the training: log odds,
  /// 0..4. Recognition::evidence compensates for it.
  double evidenceShift() const;

  /// Replaces the model's threshold: evidence below it is answered 'unknown', 0..1.
  void setUnknownThreshold(double threshold);

  const Model& model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace place_recognition
