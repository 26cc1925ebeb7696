#pragma once

#include <string>

#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {

/// A model of three drawn rooms with two cues, trained once, and its serialized bytes.
inline Training trainSmall() { return train({opener(drawFrames(3, 12))}, twoCueOptions(), 1); }

inline const Model& smallModel() {
  static const Training training = trainSmall();
  return training.model;
}

inline const std::string& smallModelBytes() {
  static const std::string bytes = serializeModel(smallModel());
  return bytes;
}

}  // namespace place_recognition
