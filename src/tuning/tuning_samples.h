#pragma once

#include <optional>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/training.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// The recordings of a search.
struct TuningRecordings {
  const std::vector<RecordingOpener>& recordings;
  const std::vector<RecordingOpener>& hold_out;  ///< for testing only; may be empty
  std::optional<ImageProfile> images = {};       ///< commonSize(recordings), if already known
};

/// Samples for the comparison of cues, each as recorded and as the next run might show it
/// (next_run.h). Only recorded images are trained on, so that cues are compared by how well they
/// tolerate changes that they have not seen.
struct TuningSamples : Samples {
  std::vector<Fold> folds;  ///< tested on recorded and changed images
};

/// Features of one in `step` labelled images of each place, see thinOut(). For errors, see
/// collectSamples().
TuningSamples collectTuningSamples(const TuningRecordings& recordings,
                                   const TrainingOptions& options, bool other_light,
                                   std::size_t step, unsigned threads, const Progress& progress);

}  // namespace place_recognition
