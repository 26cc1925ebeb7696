#pragma once

#include <string>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/feature.h"
#include "place_recognition/training.h"
#include "tuning/light.h"

namespace place_recognition {

/// The recordings that a search goes by.
struct TuningRuns {
  const std::vector<RunOpener>& runs;
  const std::vector<RunOpener>& hold_out;  ///< tested on and never trained on; may be empty
};

/// Pictures to judge cues by, each of them in every light. The first `recorded` samples are those
/// in the light of the recording, in the order of the runs.
struct LitSamples {
  std::vector<std::string> places;
  std::vector<SampleOrigin> origins;
  std::vector<std::vector<Feature>> features;  ///< [cue][sample]; some may be missing
  std::size_t recorded = 0;
  std::vector<int> source;  ///< of each sample: the recorded one that it shows; -1: not to be used
  std::vector<Fold> folds;  ///< trained on recorded samples, tested on these in every light
};

/// Features of every `step`-th labelled picture of each place. See collectSamples() for errors.
LitSamples collectLitSamples(const TuningRuns& runs, const TrainingOptions& options,
                             std::size_t step, const std::vector<Light>& lights, unsigned threads,
                             const Progress& progress);

}  // namespace place_recognition
