#pragma once

#include <optional>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/training.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// The recordings that a search goes by.
struct TuningRecordings {
  const std::vector<RecordingOpener>& recordings;
  const std::vector<RecordingOpener>& hold_out;  ///< tested on and never trained on; may be empty
  std::optional<ImageProfile> images = {};       ///< commonSize(runs), if that is known already
};

/// Samples to judge cues by, and how: each as it was recorded and as the next run might show it
/// (next_run.h). Trained on is the recording only: what looks the same in the next run has to show
/// without having been seen there.
struct TuningSamples : Samples {
  std::vector<Fold> folds;  ///< tested as recorded and changed
};

/// Features of one of every `step` labelled images of each place, see thinOut(). See
/// collectSamples() for errors.
TuningSamples collectTuningSamples(const TuningRecordings& recordings,
                                   const TrainingOptions& options, bool other_light,
                                   std::size_t step, unsigned threads, const Progress& progress);

}  // namespace place_recognition
