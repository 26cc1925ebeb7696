#pragma once

#include "place_recognition/model.h"
#include "place_recognition/recording.h"
#include "recognition/frames/light_estimate.h"

namespace place_recognition {

/// The light of a recording as one camera sees it, held against the training of a model by the
/// labels of its frames: as Recognizer does by its own answers. Not thread-safe.
class LabelledLight {
 public:
  /// Without a model, or if none of its cues follows the light of a recording, the light is always
  /// that of the training. `model` must outlive this.
  explicit LabelledLight(const Model* model);

  /// What the image of `frame`, not empty, is multiplied by to look as in the training. Its colour
  /// counts from the next frame on, if the model knows its place.
  Light next(const Frame& frame);

 private:
  const Model* model_;
  LightEstimate estimate_;
  Eigen::RowVectorXd certain_;  // one per place: 1 for the frame's, 0 for the others
};

}  // namespace place_recognition
