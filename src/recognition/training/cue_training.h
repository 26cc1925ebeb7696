#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "learning/classifier_parts.h"
#include "place_recognition/feature.h"
#include "place_recognition/training_options.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// The result of training one cue, for each of the candidate reductions.
struct TrainedCue {
  double gamma;                         ///< of the kernel: as given, or found by cross-validation
  std::vector<Feature> vectors;         ///< the support vectors before reduction
  std::vector<VectorOrigin> origins;    ///< of each vector
  std::vector<BinarySvms> machines;     ///< over `vectors`, trained on all samples
  std::vector<HeldOutValues> held_out;  ///< decision values of each sample by cross-validation
};

/// Trains one cue on the features of all samples of `task`; some may be missing, but not all. The
/// result does not depend on the number of threads.
TrainedCue trainCue(std::vector<Feature> features, const CueOptions& cue,
                    const std::vector<ReductionOptions>& reductions, const TrainingTask& task);

}  // namespace place_recognition
