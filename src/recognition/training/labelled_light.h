#pragma once

#include "place_recognition/model.h"
#include "place_recognition/recording.h"
#include "recognition/frames/light_estimate.h"

namespace place_recognition {

/// The light of a recording as one camera sees it, relative to the training of a model, from the
/// labels of its frames; Recognizer uses its own answers instead. Not thread-safe.
class LabelledLight {
 public:
  /// Without a model, or if none of its cues follows the light of a recording, the light always
  /// equals that of the training. `model` must outlive this.
  explicit LabelledLight(const Model* model);

  /// The gains that make the image of `frame`, not empty, look as in the training. Its colour
  /// counts from the next frame on, if the model knows its place.
  Light next(const Frame& frame);

 private:
  const Model* model_;
  LightEstimate estimate_;
  Eigen::RowVectorXd certain_;  // one per place: 1 for the frame's, 0 for the others
};

}  // namespace place_recognition
