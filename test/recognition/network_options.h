#pragma once

#include "features/small_network.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {

/// Returns quickOptions() with a second cue, which uses a small network.
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
