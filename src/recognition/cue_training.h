#pragma once

#include <vector>

#include "place_recognition/classifier.h"
#include "place_recognition/training_options.h"
#include "recognition/held_out.h"

namespace place_recognition {

/// What is learned for one cue.
struct TrainedCue {
  double gamma;           ///< of the kernel; as given, or as found by cross-validation
  Classifier classifier;  ///< trained on all samples, reduced
  HeldOut held_out;       ///< margins of each sample by cross-validation
};

/// Learns one cue from the features of all samples of `task`, some of which may be missing (at
/// least one is there). Deterministic, whatever the number of threads.
TrainedCue trainCue(std::vector<Feature> features, const CueOptions& cue,
                    const ReductionOptions& reduction, const TrainingTask& task);

}  // namespace place_recognition
