#pragma once

#include "features/small_network.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {

/// quickOptions() with a second cue, of a small network.
inline TrainingOptions networkOptions() {
  TrainingOptions options = quickOptions();
  CueOptions cue;
  cue.name = "embedding";
  cue.feature = SmallNetwork::options();
  cue.kernel.type = "gaussian";
  options.cues.push_back(cue);
  return options;
}

}  // namespace place_recognition
