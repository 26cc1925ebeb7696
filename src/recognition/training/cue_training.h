#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "learning/classifier_parts.h"
#include "place_recognition/feature.h"
#include "place_recognition/training_options.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// What is learned for one cue, for each of the reductions in question.
struct TrainedCue {
  double gamma;                       ///< of the kernel; as given, or as found by cross-validation
  std::vector<Feature> vectors;       ///< the support vectors before reduction
  std::vector<VectorOrigin> origins;  ///< of each of them
  std::vector<BinarySvms> machines;   ///< over `vectors`, trained on all samples
  std::vector<HeldOutValues> held_out;  ///< decision values of each sample by cross-validation
};

/// Learns one cue from the features of all samples of `task`, some of which may be missing (at
/// least one is there). Deterministic, whatever the number of threads.
TrainedCue trainCue(std::vector<Feature> features, const CueOptions& cue,
                    const std::vector<ReductionOptions>& reductions, const TrainingTask& task);

}  // namespace place_recognition
