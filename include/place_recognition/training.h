#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/recording.h"

namespace place_recognition {

/// A model and what it took.
struct Training {
  Model model;
  std::uint64_t images = 0;                      ///< trained on
  std::uint64_t passed_over = 0;                 ///< others that could have been, SamplingOptions
  std::vector<std::uint64_t> unreduced_vectors;  ///< [cue]: support vectors before reduction
  std::vector<std::string> warnings;  ///< for a person: skipped images and why, few images, ...
  double seconds = 0;
};

/// Opens a recording when its turn has come.
using RecordingOpener = std::function<std::unique_ptr<Recording>()>;

/// Learns a model from labelled recordings: features of every frame (memory is bounded by them, not
/// by the runs), Gram matrix, gamma by cross-validation where it is not given, machines, reduction
/// (for `auto` chosen by cross-validation), calibration on held-out blocks of time. Throws Error if
/// fewer than two places have images; Cancelled if `progress` asks for it. The model's bytes depend
/// on inputs and options only, not on `threads` (0: one per core).
Training train(const std::vector<RecordingOpener>& recordings, const TrainingOptions& options,
               unsigned threads = 0, const Progress& progress = {});

/// How a model learns on.
struct IncrementalOptions {
  /// Support vectors that each cue keeps at most: the threshold of shared-greedy reduction is
  /// adapted to it, which forgets what matters least to all decision values together. 0: as many as
  /// it needs, or the reduction that was asked for if that has a number or a tau.
  int vector_limit = 0;
  /// Within that limit, how much less the decision values at a vector count each time that its
  /// place is learned again, 0..1. 0: it is forgotten for its weight only, not for its age.
  double forgetting = 0;
  /// The model of another robot, of which the support vectors are learned, too.
  const Model* other = nullptr;
};

/// Learns on (thesis section 9.1): trains on what `model` remembers, its support vectors, and on
/// the labelled frames of new `recordings`, which may hold known places or new ones (none, if there
/// is another model); features, kernels and gammas stay those of the model. Held-out frames of the
/// new runs and those that judged the models decide together on the weights of the cues and on the
/// calibration. Errors as train(), but one new place is enough; and if the models were trained with
/// different features.
Training trainIncrementally(const Model& model, const std::vector<RecordingOpener>& recordings,
                            const IncrementalOptions& incremental, unsigned threads = 0,
                            const Progress& progress = {});

}  // namespace place_recognition
